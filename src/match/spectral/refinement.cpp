// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "base/parallel.hpp"
#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/local_search.hpp"

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

Points positions_of_images(const Shape& b, const std::vector<Index>& b_from_a) {
    Points positions(static_cast<Eigen::Index>(b_from_a.size()), 3);
    for (std::size_t v = 0; v < b_from_a.size(); ++v)
        positions.row(static_cast<Eigen::Index>(v)) = b.mesh.vertices.row(b_from_a[v]);
    return positions;
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
    const SampledPair pair(a, b, a.samples.size());
    PairedMaps maps = match_points(pair.points_a, pair.points_b, start);
    std::vector<int> sizes;
    for (int k = 90; k <= options.last; k += 10) sizes.push_back(k);
    maps = zoom_out(pair.points_a, pair.points_b, std::move(maps), sizes, true);
    PairedFunctionalMaps functional =
        fit_functional_maps(pair.points_a, pair.points_b, maps, options.last, true);
    if (std::max(a.mesh.n_vertices(), b.mesh.n_vertices()) > large_mesh)
        return match_points_nearby(a, b, functional, maps);

    const MatrixF features_a = features(a, options.feature_weight),
                  features_b = features(b, options.feature_weight);
    maps = match_points(a.all, b.all, functional, {features_a, features_b});
    const ElasticFit fit(a.mesh.vertices, a.laplacian, options.stiffness_length);
    const MatrixF place_b =
        beside(features_b, b.mesh.vertices, options.position_weight, b.normals, options.normal_weight);
    Points moved;
    for (int round = 0; round < options.rounds; ++round) {
        functional = fit_functional_maps(a.all, b.all, maps, options.last, true);
        const Points images = positions_of_images(b, maps.b_from_a);
        moved = fit(images, round == 0 ? images : moved, options.iterations);
        const Points normals = vertex_normals({moved, a.mesh.triangles});
        maps = match_points(
            a.all, b.all, functional,
            {beside(features_a, moved, options.position_weight, normals, options.normal_weight), place_b});
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
