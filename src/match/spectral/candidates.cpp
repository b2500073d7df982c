// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/candidates.hpp"

#include "base/parallel.hpp"
#include "match/spectral/extremity_matching.hpp"
#include "match/spectral/poses.hpp"

#include <counterpart/spectral/functional_map.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

constexpr int start_size = 20;  // functions of the first functional map
constexpr int coarse_size = 30;
constexpr int pose_size = 5;  // alike poses tell little more than the coarsest functions do

std::vector<int> sizes_between(int first, int last, int step) {
    std::vector<int> sizes;
    for (int k = first; k < last; k += step) sizes.push_back(k);
    sizes.push_back(last);
    return sizes;
}

Eigen::MatrixXd unit_columns(Eigen::MatrixXd m) {
    for (Eigen::Index j = 0; j < m.cols(); ++j) m.col(j) /= std::max(m.col(j).norm(), 1e-12);
    return m;
}

// Coefficients of a shape's descriptors: wave kernel and curvature.
Eigen::MatrixXd descriptor_coefficients(const Shape& shape, int k) {
    const Eigen::MatrixXd dual =
        shape.basis.eigenfunctions.leftCols(k).transpose() * shape.basis.mass.asDiagonal();
    const Eigen::MatrixXd wave = unit_columns(dual * shape.wave_kernel) * 0.2;
    const Eigen::MatrixXd curvature = unit_columns(dual * shape.curvature) * 0.3;
    Eigen::MatrixXd all(k, wave.cols() + curvature.cols());
    all << wave, curvature;
    return all;
}

// The same, followed by those of heat kernels at the given vertices.
Eigen::MatrixXd with_heat_kernels(const Eigen::MatrixXd& descriptors, const Shape& shape,
                                  const std::vector<Index>& vertices) {
    const std::vector<double> times{0.005, 0.02, 0.06};
    const Eigen::Index k = descriptors.rows();
    Eigen::MatrixXd heat(k, static_cast<Eigen::Index>(vertices.size() * times.size()));
    Eigen::Index column = 0;
    for (const Index v : vertices)
        for (const double t : times)
            heat.col(column++) = shape.basis.eigenfunctions.row(v).head(k).transpose().array() *
                                 (-t * shape.basis.eigenvalues.head(k).array()).exp();
    Eigen::MatrixXd all(k, descriptors.cols() + heat.cols());
    all << descriptors, unit_columns(heat);
    return all;
}

// A candidate's first two maps, enough to tell whether it is going to be like another one.
struct Beginning {
    PairedMaps maps;
    int size = 0;  // functions that it is fitted to
};

Beginning begin(const SampledPair& pair, const PairedFunctionalMaps& start) {
    const int size = std::min(static_cast<int>(start.a_from_b.rows()) + 1, coarse_size);
    return {zoom_out(pair.points_a, pair.points_b, match_points(pair.points_a, pair.points_b, start), {size},
                     false),
            size};
}

Candidate grow(const SampledPair& pair, Beginning beginning) {
    Candidate candidate;
    candidate.maps =
        zoom_out(pair.points_a, pair.points_b, std::move(beginning.maps),
                 sizes_between(std::min(beginning.size + 5, coarse_size), coarse_size, 5), false);
    candidate.functional =
        fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, coarse_size, false);
    candidate.scores = score_maps(pair, candidate.maps, candidate.functional, coarse_score);
    return candidate;
}

PairedFunctionalMaps flipped(const PairedFunctionalMaps& maps, int column) {
    const int k = column + 1;
    PairedFunctionalMaps result{maps.a_from_b.topLeftCorner(k, k), maps.b_from_a.topLeftCorner(k, k)};
    result.a_from_b.col(column) *= -1;
    result.b_from_a.row(column) *= -1;
    return result;
}

using Pairs = std::vector<std::pair<Index, Index>>;

// Vertices that starts take as corresponding; an empty list means descriptors alone.
std::vector<Pairs> anchors(const SampledPair& pair, const Pairs& landmarks) {
    constexpr std::size_t n_matchings = 24;
    if (!landmarks.empty()) return {landmarks};
    std::vector<Pairs> result;
    for (const ExtremityMatching& matching : match_extremities(pair.a, pair.b, n_matchings)) {
        result.emplace_back();
        for (const auto& [i, j] : matching.pairs)
            result.back().emplace_back(pair.a.extremities[static_cast<std::size_t>(i)].vertex,
                                       pair.b.extremities[static_cast<std::size_t>(j)].vertex);
    }
    result.emplace_back();
    return result;
}

std::vector<Candidate> grown_from_anchors(const SampledPair& pair, const std::vector<Pairs>& anchors) {
    const int k = std::min({start_size, pair.a.basis.size(), pair.b.basis.size()});
    const Eigen::MatrixXd descriptors_a = descriptor_coefficients(pair.a, k),
                          descriptors_b = descriptor_coefficients(pair.b, k);
    std::vector<Candidate> candidates(anchors.size());
    parallel_for(anchors.size(), 1, [&](std::size_t i) {
        std::vector<Index> on_a, on_b;
        for (const auto& [va, vb] : anchors[i]) {
            on_a.push_back(va);
            on_b.push_back(vb);
        }
        const MatrixF c =
            fit_functional_map(with_heat_kernels(descriptors_a, pair.a, on_a), pair.a.basis.eigenvalues,
                               with_heat_kernels(descriptors_b, pair.b, on_b), pair.b.basis.eigenvalues)
                .cast<float>();
        candidates[i] = grow(pair, begin(pair, {c, c.transpose()}));
    });
    return candidates;
}

void add_grown(std::vector<Candidate>& candidates, const SampledPair& pair,
               std::vector<Beginning> beginnings) {
    const std::size_t n_before = candidates.size();
    candidates.resize(n_before + beginnings.size());
    parallel_for(beginnings.size(), 1,
                 [&](std::size_t i) { candidates[n_before + i] = grow(pair, std::move(beginnings[i])); });
}

// The sign flips of the best candidates that were not varied before.
std::vector<Beginning> variations(const SampledPair& pair, std::vector<Candidate>& candidates) {
    constexpr std::size_t n_varied = 24;
    constexpr Eigen::Index first_flip = 5, last_flip = 17;
    std::vector<std::pair<std::size_t, int>> flips;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < candidates.size() && chosen < n_varied; ++i) {
        if (candidates[i].varied) continue;
        candidates[i].varied = true;
        ++chosen;
        const MatrixF& map = candidates[i].functional.a_from_b;
        const Eigen::Index last = std::min({last_flip, map.rows() - 1, map.cols() - 1});
        for (Eigen::Index column = first_flip; column <= last; ++column)
            flips.emplace_back(i, static_cast<int>(column));
    }
    std::vector<Beginning> beginnings(flips.size());
    parallel_for(flips.size(), 1, [&](std::size_t f) {
        beginnings[f] = begin(pair, flipped(candidates[flips[f].first].functional, flips[f].second));
    });
    return beginnings;
}

// Those unlike all in `known`, which they join.
std::vector<Beginning> unknown(std::vector<Beginning> beginnings, const MapDistance& distance,
                               std::vector<PairedMaps>& known) {
    constexpr double least_difference = 0.03;
    std::vector<Beginning> fresh;
    for (Beginning& beginning : beginnings) {
        const bool is_new = std::all_of(known.begin(), known.end(), [&](const PairedMaps& other) {
            return distance(beginning.maps, other) >= least_difference;
        });
        if (!is_new) continue;
        known.push_back(beginning.maps);
        fresh.push_back(std::move(beginning));
    }
    return fresh;
}

}  // namespace

MapDistance::MapDistance(const SampledPair& pair) : a_(pair.a), b_(pair.b) {
    const auto nearest = [](const Shape& shape, Index n_samples) {
        std::vector<Index> result;
        for (Index s = 0; s < n_samples; ++s) {
            Eigen::Index row = 0;
            shape.sample_distances.col(shape.samples[static_cast<std::size_t>(s)]).minCoeff(&row);
            result.push_back(static_cast<Index>(row));
        }
        return result;
    };
    nearest_a_ = nearest(a_, pair.points_a.size());
    nearest_b_ = nearest(b_, pair.points_b.size());
}

double MapDistance::operator()(const PairedMaps& x, const PairedMaps& y) const {
    const auto mean = [](const Shape& to, const std::vector<Index>& nearest, const std::vector<Index>& f,
                         const std::vector<Index>& g) {
        double sum = 0;
        for (std::size_t s = 0; s < f.size(); ++s) {
            const Index i = nearest[static_cast<std::size_t>(f[s])],
                        j = nearest[static_cast<std::size_t>(g[s])];
            sum += to.sample_distances(i, to.samples[static_cast<std::size_t>(j)]);
        }
        return sum / static_cast<double>(std::max<std::size_t>(f.size(), 1));
    };
    return (mean(b_, nearest_b_, x.b_from_a, y.b_from_a) + mean(a_, nearest_a_, x.a_from_b, y.a_from_b)) / 2;
}

double MapDistance::on_b(Index sample, Index other) const {
    return b_.sample_distances(
        nearest_b_[static_cast<std::size_t>(sample)],
        b_.samples[static_cast<std::size_t>(nearest_b_[static_cast<std::size_t>(other)])]);
}

double MapDistance::share_beyond(const PairedMaps& x, const PairedMaps& y, double distance) const {
    std::size_t count = 0;
    for (std::size_t s = 0; s < x.b_from_a.size(); ++s) {
        const Index i = nearest_b_[static_cast<std::size_t>(x.b_from_a[s])];
        const Index j = nearest_b_[static_cast<std::size_t>(y.b_from_a[s])];
        if (b_.sample_distances(i, b_.samples[static_cast<std::size_t>(j)]) > distance) ++count;
    }
    return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(x.b_from_a.size(), 1));
}

void keep_distinct(std::vector<Candidate>& candidates, const MapDistance& distance, double least,
                   std::size_t count) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& x, const Candidate& y) { return x.scores.total > y.scores.total; });
    std::vector<Candidate> kept;
    for (Candidate& candidate : candidates) {
        if (kept.size() == count) break;
        const bool is_new = std::all_of(kept.begin(), kept.end(), [&](const Candidate& other) {
            return distance(candidate.maps, other.maps) >= least;
        });
        if (is_new) kept.push_back(std::move(candidate));
    }
    candidates = std::move(kept);
}

std::vector<Candidate> find_candidates(const SampledPair& pair, const Pairs& landmarks, std::size_t count) {
    constexpr std::size_t n_pool = 60;
    constexpr int n_rounds = 2;
    constexpr double least_difference = 0.05;
    std::vector<Candidate> candidates = grown_from_anchors(pair, anchors(pair, landmarks));
    if (landmarks.empty()) {
        std::vector<Beginning> posed;
        for (PairedMaps& maps : maps_between_poses(pair)) posed.push_back({std::move(maps), pose_size});
        add_grown(candidates, pair, std::move(posed));
    }
    const MapDistance distance(pair);
    keep_distinct(candidates, distance, least_difference, candidates.size());
    std::vector<PairedMaps> known;
    for (int round = 0; round < n_rounds; ++round) {
        add_grown(candidates, pair, unknown(variations(pair, candidates), distance, known));
        keep_distinct(candidates, distance, least_difference, n_pool);
    }
    if (candidates.size() > count) candidates.resize(count);
    return candidates;
}

}  // namespace counterpart::spectral_match
