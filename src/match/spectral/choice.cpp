// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/choice.hpp"

#include "base/parallel.hpp"
#include "match/spectral/crossover.hpp"

#include <algorithm>
#include <iterator>

namespace counterpart::spectral_match {
namespace {

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

std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count) {
    const SampledPair middle(a, b, 600, 0.2);
    grow_all(candidates, middle, middle_sizes, false, 80, middle_score);
    improve(candidates, SampledPair(a, b, 300, 0.3), middle);
    if (candidates.size() > count) candidates.resize(count);
    const std::size_t all = std::max(a.samples.size(), b.samples.size());
    grow_all(candidates, SampledPair(a, b, all, 0.15), {95, 110, 130, 150}, true, 100, fine_score);
    return candidates;
}

}  // namespace counterpart::spectral_match
