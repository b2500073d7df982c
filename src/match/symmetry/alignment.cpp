// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/symmetry/alignment.hpp"

#include <algorithm>

namespace counterpart::symmetry {

Alignment fit_alignment(const std::vector<PointPair>& pairs, bool may_reflect) {
    if (pairs.empty()) return {};
    const auto n = static_cast<Eigen::Index>(pairs.size());
    Points source(n, 3), target(n, 3);
    Vector weights(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const PointPair& pair = pairs[static_cast<std::size_t>(i)];
        source.row(i) = pair.source;
        target.row(i) = pair.target;
        weights[i] = pair.weight;
    }
    KabschOptions options;
    options.with_scale = true;
    const Alignment rotation{kabsch(source, target, weights, options), false};
    if (!may_reflect) return rotation;
    const Alignment reflection{kabsch(Points(-source), target, weights, options), true};
    return squared_error(reflection, pairs) < squared_error(rotation, pairs) ? reflection : rotation;
}

Alignment fit_alignment_near(const Eigen::RowVector3d& point, std::vector<PointPair> pairs,
                             bool may_reflect) {
    double extent = 0;
    for (const PointPair& pair : pairs) extent = std::max(extent, (pair.source - point).squaredNorm());
    // Without a floor the closest pair alone would count, which fixes no rotation.
    const double floor = 1e-3 * extent;
    for (PointPair& pair : pairs) {
        const double falloff = (pair.source - point).squaredNorm() + floor;
        pair.weight = falloff > 0 ? 1 / (falloff * falloff) : 1;
    }
    return fit_alignment(pairs, may_reflect);
}

double squared_error(const Alignment& alignment, const std::vector<PointPair>& pairs) {
    double sum = 0, total = 0;
    for (const PointPair& pair : pairs) {
        sum += pair.weight * (alignment(pair.source) - pair.target).squaredNorm();
        total += pair.weight;
    }
    return total > 0 ? sum / total : 0;
}

}  // namespace counterpart::symmetry
