// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/one_way_fit.hpp"

#include "base/parallel.hpp"
#include "match/spectral/elastic_fit.hpp"

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
    std::vector<double> sorted(distance.begin(), distance.end());
    std::nth_element(sorted.begin(), sorted.begin() + n / 2, sorted.end());
    const double scale = std::max(tuning.robust_factor * sorted[at(n / 2)], tuning.min_scale);
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

BentSource fit_one_way(const Surface& source, const LaplaceBeltrami& laplacian, const Surface& target,
                       const numerics::OrientedNeighbors& on_target, const std::vector<Index>& start,
                       std::vector<std::pair<Index, Index>> pins, const FitTuning& tuning,
                       const ProgressRange& progress) {
    const Eigen::Index n = source.mesh.n_vertices();
    spectral_match::RefinementTuning rigid;
    rigid.min_scale = rigid.max_scale = 1;  // the common unit is known: parts of one surface keep their size
    spectral_match::ElasticFit fit(source.mesh.vertices, laplacian, rigid);
    BentSource bent{start, Points(n, 3), source.normals, 0, std::move(pins)};
    Vector trust = Vector::Ones(n);
    const auto pin = [&] {
        for (const auto& [v, image] : bent.pins) {
            bent.image[at(v)] = image;
            trust[v] = tuning.pin_trust;
        }
    };
    for (Eigen::Index v = 0; v < n; ++v) {
        if (start[at(v)] < 0) trust[v] = tuning.min_trust, bent.image[at(v)] = 0;
        bent.positions.row(v) = target.mesh.vertices.row(bent.image[at(v)]);
        if (target.on_boundary[at(bent.image[at(v)])] != 0) trust[v] *= tuning.beyond_trust;
    }
    pin();
    for (const auto& [v, image] : bent.pins) bent.positions.row(v) = target.mesh.vertices.row(image);
    const double ratio =
        std::pow(tuning.last_length / tuning.first_length, 1.0 / std::max(tuning.n_rounds - 1, 1));
    double length = tuning.first_length;
    for (int round = 0; round < tuning.n_rounds; ++round, length *= ratio) {
        Points towards(n, 3);
        for (Eigen::Index v = 0; v < n; ++v) towards.row(v) = target.mesh.vertices.row(bent.image[at(v)]);
        if (round > 0) trust = trust_in(bent, target, tuning);
        pin();
        bent.positions = fit(towards, bent.positions, length,
                             round == 0 ? tuning.n_first_iterations : tuning.n_iterations, progress, trust);
        bent.normals = vertex_normals({bent.positions, source.mesh.triangles});
        parallel_for(at(n), 64, [&](std::size_t v) {
            const auto row = static_cast<Eigen::Index>(v);
            bent.image[v] = on_target.closest(bent.positions.row(row), bent.normals.row(row));
        });
        pin();
        progress.reach((round + 1.0) / tuning.n_rounds);
    }
    bent.strain = fit.strain(bent.positions);
    return bent;
}

}  // namespace counterpart::partial_match
