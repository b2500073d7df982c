// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refinement.hpp"

#include "base/parallel.hpp"
#include "match/spectral/crossover.hpp"
#include "match/spectral/elastic_fit.hpp"
#include "match/spectral/local_search.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <iterator>

namespace counterpart::spectral_match {
namespace {

constexpr int chosen_size = 150;  // functions among which the best candidate is chosen

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

// Candidates carried on to more functions on the samples of `pair`, best first. Scores are of the functional
// maps between the first `scored_size` functions.
void grow_all(std::vector<Candidate>& candidates, const SampledPair& pair, const std::vector<int>& sizes,
              bool masked, int scored_size, const ScoreWeights& weights) {
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(pair.points_a, pair.points_b, candidate.functional);
        candidate.maps = zoom_out(pair.points_a, pair.points_b, std::move(candidate.maps), sizes, masked);
        candidate.functional =
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, sizes.back(), masked);
        candidate.scores = score_maps(
            pair, candidate.maps,
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, scored_size, false), weights);
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.scores.total > y.scores.total; });
}

const std::vector<int> middle_sizes{40, 50, 60, 80};

// Those of the best candidate with each other one, all different.
std::vector<Candidate> children_of_best(const std::vector<Candidate>& candidates, const SampledPair& pair) {
    constexpr double least_difference = 0.01;
    const MapDistance distance(pair);
    std::vector<Candidate> children;
    for (std::size_t other = 1; other < candidates.size(); ++other) {
        for (Candidate& child : crossovers(pair, candidates.front(), candidates[other])) {
            const auto same = [&](const Candidate& known) {
                return distance(child.maps, known.maps) < least_difference;
            };
            if (std::none_of(children.begin(), children.end(), same)) children.push_back(std::move(child));
        }
    }
    return children;
}

// A map may be right except for two legs, and another one have just these right: the best candidate is
// crossed with all others for as long as that gives a better one. `few` samples sift the children.
void improve(std::vector<Candidate>& candidates, const SampledPair& few, const SampledPair& pair) {
    constexpr int n_rounds = 3;
    constexpr std::size_t n_grown = 12;
    constexpr double least_difference = 0.02;
    const std::size_t n_kept = candidates.size();
    const MapDistance distance(pair);
    for (Candidate& candidate : candidates) candidate.varied = false;
    for (int round = 0; round < n_rounds && !candidates.front().varied; ++round) {
        candidates.front().varied = true;
        std::vector<Candidate> children = children_of_best(candidates, pair);
        grow_all(children, few, {35, 40}, false, 40, middle_score);
        children.resize(std::min(children.size(), n_grown));
        grow_all(children, pair, middle_sizes, false, 80, middle_score);
        candidates.insert(candidates.end(), std::make_move_iterator(children.begin()),
                          std::make_move_iterator(children.end()));
        keep_distinct(candidates, distance, least_difference, n_kept);
    }
}

}  // namespace

PairedMaps refine(const Shape& a, const Shape& b, const Candidate& start, const RefineOptions& options) {
    const SampledPair pair(a, b, std::max(a.samples.size(), b.samples.size()), 0);
    std::vector<int> sizes;
    for (int k = chosen_size + 10; k <= options.last; k += 10) sizes.push_back(k);
    const PairedMaps sample_maps = zoom_out(pair.points_a, pair.points_b, start.maps, sizes, true);
    PairedFunctionalMaps functional =
        fit_functional_maps(pair.points_a, pair.points_b, sample_maps, options.last, true);
    const MatrixF features_a = features(a, options.feature_weight),
                  features_b = features(b, options.feature_weight);
    PairedMaps maps =
        match_points_nearby(a, b, functional, spread(a, b, sample_maps), 2, {features_a, features_b});
    const ElasticFit fit(a.mesh.vertices, a.laplacian, options.stiffness_length);
    const MatrixF place_b =
        beside(features_b, b.mesh.vertices, options.position_weight, b.normals, options.normal_weight);
    Points moved;
    const bool is_huge = std::max(a.mesh.n_vertices(), b.mesh.n_vertices()) > 3 * large_mesh;
    const int n_rounds = is_huge ? options.rounds_if_huge : options.rounds;
    for (int round = 0; round < n_rounds; ++round) {
        functional = fit_functional_maps(a.all, b.all, maps, options.last, true);
        const Points images = positions_of_images(b, maps.b_from_a);
        moved = fit(images, round == 0 ? images : moved, options.iterations);
        const Points normals = vertex_normals({moved, a.mesh.triangles});
        maps = match_points_nearby(
            a, b, functional, maps, 1,
            {beside(features_a, moved, options.position_weight, normals, options.normal_weight), place_b});
    }
    return maps;
}

std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count) {
    const SampledPair middle(a, b, 600, 0.2);
    grow_all(candidates, middle, middle_sizes, false, 80, middle_score);
    improve(candidates, SampledPair(a, b, 300, 0.3), middle);
    if (candidates.size() > count) candidates.resize(count);
    const std::size_t all = std::max(a.samples.size(), b.samples.size());
    grow_all(candidates, SampledPair(a, b, all, 0.15), {95, 110, 130, chosen_size}, true, 100, fine_score);
    return candidates;
}

}  // namespace counterpart::spectral_match
