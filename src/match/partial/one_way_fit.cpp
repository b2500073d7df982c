// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/one_way_fit.hpp"

#include "align/elastic_fit.hpp"
#include "base/parallel.hpp"
#include "numerics/median.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::partial_match {
namespace {

std::size_t at(Eigen::Index v) { return static_cast<std::size_t>(v); }

// Vertices far from their images, or turned against them, hardly pull.
Vector trust_in(const BentSource& bent, const Surface& target, const FitTuning& tuning) {
    const Eigen::Index n = bent.positions.rows();
    Vector distance(n), trust(n);
    for (Eigen::Index v = 0; v < n; ++v)
        distance[v] = (bent.positions.row(v) - target.mesh.vertices.row(bent.image[at(v)])).norm();
    const double middle = numerics::median(std::vector<double>(distance.begin(), distance.end()));
    const double scale = std::max(tuning.robust_factor * middle, tuning.min_scale);
    for (Eigen::Index v = 0; v < n; ++v) {
        const double x = distance[v] / scale, fall = 1 / (1 + x * x);
        trust[v] = std::max(fall * fall, tuning.min_trust);
        if (bent.normals.row(v).dot(target.normals.row(bent.image[at(v)])) < tuning.min_cosine)
            trust[v] *= tuning.turned_trust;
        if (target.on_boundary[at(bent.image[at(v)])] != 0) trust[v] *= tuning.beyond_trust;
    }
    return trust;
}

}  // namespace

OneWayFit::OneWayFit(const Surface& source, const Surface& target, const FitTuning& tuning)
    : source_(source),
      target_(target),
      tuning_(tuning),
      laplacian_(laplace_beltrami(source.mesh)),
      on_target_(target.mesh.vertices, target.normals, tuning.normal_weight) {}

struct OneWayFit::State {
    BentSource bent;
    Vector trust;
    std::vector<char> pulls;

    // What is known, against what was seen.
    void apply_known(const FitTuning& tuning) {
        for (std::size_t v = 0; v < pulls.size(); ++v)
            if (pulls[v] == 0)
                trust[static_cast<Index>(v)] =
                    std::max(tuning.held_share * trust[static_cast<Index>(v)], tuning.least_trust);
        for (const auto& [v, image] : bent.pins) {
            bent.image[at(v)] = image;
            trust[v] = tuning.pin_trust;
        }
    }
};

void OneWayFit::find_images(BentSource& bent) const {
    bent.image.resize(static_cast<std::size_t>(bent.positions.rows()));
    parallel_for(bent.image.size(), 64, [&](std::size_t v) {
        const auto row = static_cast<Eigen::Index>(v);
        bent.image[v] = on_target_.closest(bent.positions.row(row), bent.normals.row(row));
    });
}

// Bent already, or at its images, each trusted alike but for those on
// boundaries.
OneWayFit::State OneWayFit::start_state(FitStart start) const {
    State state{
        {std::move(start.image), std::move(start.positions), source_.normals, 0, std::move(start.pins)},
        Vector::Ones(source_.mesh.n_vertices()),
        std::move(start.pulls)};
    BentSource& bent = state.bent;
    const bool is_bent = bent.positions.rows() > 0;
    if (is_bent) {
        bent.normals = vertex_normals({bent.positions, source_.mesh.triangles});
        if (bent.image.empty()) find_images(bent);
        state.trust = trust_in(bent, target_, tuning_);
    } else {
        for (Eigen::Index v = 0; v < state.trust.size(); ++v) {
            if (bent.image[at(v)] < 0) state.trust[v] = tuning_.min_trust, bent.image[at(v)] = 0;
            if (target_.on_boundary[at(bent.image[at(v)])] != 0) state.trust[v] *= tuning_.beyond_trust;
        }
    }
    state.apply_known(tuning_);
    if (!is_bent) bent.positions = target_.mesh.vertices(bent.image, Eigen::all);
    return state;
}

BentSource OneWayFit::operator()(FitStart start, const ProgressRange& progress) const {
    // The common unit is known: parts of one surface keep their size.
    align::ElasticFit fit(source_.mesh.vertices, laplacian_.stiffness, {.scales = {1, 1}, .settled = 1e-4});
    State state = start_state(std::move(start));
    BentSource& bent = state.bent;
    const double ratio =
        std::pow(tuning_.last_length / tuning_.first_length, 1.0 / std::max(tuning_.n_rounds - 1, 1));
    double length = tuning_.first_length;
    for (int round = 0; round < tuning_.n_rounds; ++round, length *= ratio) {
        const Points towards = target_.mesh.vertices(bent.image, Eigen::all);
        bent.positions =
            fit(towards, state.trust.cwiseProduct(laplacian_.mass) / (length * length), bent.positions,
                round == 0 ? tuning_.n_first_iterations : tuning_.n_iterations, progress);
        bent.normals = vertex_normals({bent.positions, source_.mesh.triangles});
        find_images(bent);
        state.trust = trust_in(bent, target_, tuning_);
        state.apply_known(tuning_);
        progress.reach((round + 1.0) / tuning_.n_rounds);
    }
    bent.strain = fit.strain(bent.positions);
    return std::move(state.bent);
}

}  // namespace counterpart::partial_match
