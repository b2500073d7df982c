// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "base/parallel.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// Curvature at four scales and eight wave kernel columns, each of mean 0 and variance 1.
MatrixF features(const Shape& shape, float weight) {
    Eigen::MatrixXd all(shape.mesh.n_vertices(), 12);
    for (int j = 0; j < 4; ++j) all.col(j) = shape.curvature.col(j);
    for (int j = 0; j < 8; ++j) all.col(4 + j) = shape.wave_kernel.col(j * 5 + 2);
    const Vector mass = shape.basis.mass / shape.basis.mass.sum();
    for (int j = 0; j < 12; ++j) {
        all.col(j).array() -= mass.dot(all.col(j));
        all.col(j) /= std::sqrt(std::max(mass.dot(all.col(j).cwiseAbs2()), 1e-20));
    }
    // The embedding's squared length is about its number of functions.
    return all.cast<float>() * weight;
}

// A moved onto B by the low frequencies of the displacement that the map asks for (Eisenberger et al. 2020).
Points smooth_shell(const Shape& a, const Shape& b, const std::vector<Index>& b_from_a, int k) {
    Points displacement(a.mesh.n_vertices(), 3);
    for (Index v = 0; v < a.mesh.n_vertices(); ++v)
        displacement.row(v) =
            b.mesh.vertices.row(b_from_a[static_cast<std::size_t>(v)]) - a.mesh.vertices.row(v);
    const auto phi = a.basis.eigenfunctions.leftCols(k);
    const Eigen::MatrixXd coefficients = phi.transpose() * (a.basis.mass.asDiagonal() * displacement);
    return a.mesh.vertices + phi * coefficients;
}

MatrixF beside(const MatrixF& x, const Points& positions, float position_weight, const Points& normals,
               float normal_weight) {
    MatrixF all(x.rows(), x.cols() + 6);
    all << x, positions.cast<float>() * position_weight, normals.cast<float>() * normal_weight;
    return all;
}

}  // namespace

PairedMaps refine(const Shape& a, const Shape& b, const PairedFunctionalMaps& start,
                  const RefineOptions& options) {
    const std::size_t n = a.samples.size();
    const SampledPair pair(a, b, n);
    PairedMaps maps = match_points(pair.points_a, pair.points_b, start);
    std::vector<int> sizes;
    for (int k = 90; k <= options.last; k += 10) sizes.push_back(k);
    maps = zoom_out(pair.points_a, pair.points_b, std::move(maps), sizes, true);
    PairedFunctionalMaps functional =
        fit_functional_maps(pair.points_a, pair.points_b, maps, options.last, true);
    const MatrixF fa = features(a, options.feature_weight), fb = features(b, options.feature_weight);
    maps = match_points(a.all, b.all, functional, {fa, fb});
    for (int round = 0; round < options.rounds; ++round) {
        functional = fit_functional_maps(a.all, b.all, maps, options.last, true);
        if (options.position_weight > 0 || options.normal_weight > 0) {
            const Points moved = smooth_shell(a, b, maps.b_from_a, 60 + 40 * round);
            const Points normals = vertex_normals({moved, a.mesh.triangles});
            maps = match_points(
                a.all, b.all, functional,
                {beside(fa, moved, options.position_weight, normals, options.normal_weight),
                 beside(fb, b.mesh.vertices, options.position_weight, b.normals, options.normal_weight)});
        } else {
            maps = match_points(a.all, b.all, functional, {fa, fb});
        }
    }
    return maps;
}

std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count) {
    const auto better = [](const Candidate& x, const Candidate& y) {
        return x.scores.total > y.scores.total;
    };
    const SampledPair pair(a, b, 600);
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(pair.points_a, pair.points_b, candidate.functional);
        candidate.maps =
            zoom_out(pair.points_a, pair.points_b, std::move(candidate.maps), {40, 50, 60, 80}, false);
        candidate.functional = fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, 80, false);
        candidate.scores = score_maps(pair, candidate.maps, candidate.functional, 1, 0.2);
    });
    std::stable_sort(candidates.begin(), candidates.end(), better);
    if (candidates.size() > count) candidates.resize(count);
    return candidates;
}

}  // namespace counterpart::spectral_match
