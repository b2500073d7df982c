// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/requests.hpp"

#include "base/to_size.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::partial_match {
namespace {

// How near excluded pairs come to each other, and what the coordinates along common directions lack to being
// roughly in the same order; as the priors of the spectral method.
double disagreement(const Fit& fit, const Surface& part, const Surface& whole, const Requests& requests,
                    const spectral_match::PriorTuning& tuning) {
    double result = 0;
    const auto image = [&](Index v) { return whole.mesh.vertices.row(fit.bent.image[to_size(v)]); };
    for (const auto& [from, to] : requests.excluded)
        result += tuning.excluded_weight *
                  std::max(0.0, tuning.excluded_radius - (image(from) - whole.mesh.vertices.row(to)).norm());
    const Eigen::Index n = part.mesh.vertices.rows(), n_directions = requests.directions.cols();
    for (Eigen::Index d = 0; d < n_directions; ++d) {
        Vector x = part.mesh.vertices * requests.directions.col(d), y(n);
        for (Eigen::Index v = 0; v < n; ++v)
            y[v] = image(static_cast<Index>(v)).dot(requests.directions.col(d));
        x.array() -= x.mean();
        y.array() -= y.mean();
        constexpr double flat = 1e-9;  // a sheet has no order along its normal
        if (std::min(x.norm(), y.norm()) < flat * std::sqrt(static_cast<double>(n))) continue;
        const double correlation = x.dot(y) / (x.norm() * y.norm());
        result += tuning.direction_weight * std::max(0.0, tuning.enough_correlation - correlation) /
                  static_cast<double>(n_directions);
    }
    return result;
}

}  // namespace

SpectralOptions as_of_spectral(const PartialOptions& options) {
    SpectralOptions result;
    result.landmarks = options.landmarks;
    result.soft_landmarks = options.soft_landmarks;
    result.excluded = options.excluded;
    result.aligned = options.aligned;
    result.up = options.up;
    result.facing = options.facing;
    result.symmetric = options.mirrored;
    result.n_alternatives = options.n_alternatives;
    return result;
}

void rank(std::vector<Fit>& found, const Surface& part, const Surface& whole, const Requests& requests,
          const spectral_match::PriorTuning& tuning) {
    for (Fit& fit : found) fit.total -= disagreement(fit, part, whole, requests, tuning);
    std::stable_sort(found.begin(), found.end(),
                     [](const Fit& a, const Fit& b) { return a.total > b.total; });
}

}  // namespace counterpart::partial_match
