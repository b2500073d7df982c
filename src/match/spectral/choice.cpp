// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/choice.hpp"

#include "base/parallel.hpp"
#include "match/spectral/crossover.hpp"
#include "match/spectral/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

bool by_score(const Candidate& x, const Candidate& y) { return x.scores.total > y.scores.total; }

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
    std::stable_sort(candidates.begin(), candidates.end(), by_score);
}

const std::vector<int> middle_sizes{40, 50, 60, 80};

// Of `base` with each of `others`, all different.
std::vector<Candidate> children(const Candidate& base, const std::vector<Candidate>& others,
                                const SampledPair& pair, const MapDistance& distance) {
    constexpr double least_difference = 0.01;
    std::vector<Candidate> result;
    for (const Candidate& other : others) {
        for (Candidate& child : crossovers(pair, base, other)) {
            const auto same = [&](const Candidate& known) {
                return distance(child.maps, known.maps) < least_difference;
            };
            if (std::none_of(result.begin(), result.end(), same)) result.push_back(std::move(child));
        }
    }
    return result;
}

// A map may be right except for two legs, and another one have just these right: it is crossed with all
// others for as long as that gives a better one. `few` samples sift the children.
Candidate improved(Candidate best, const std::vector<Candidate>& others, const SampledPair& few,
                   const SampledPair& pair) {
    constexpr int n_rounds = 3;
    constexpr std::size_t n_grown = 6;
    const MapDistance distance(pair);
    for (int round = 0; round < n_rounds; ++round) {
        std::vector<Candidate> born = children(best, others, pair, distance);
        grow_all(born, few, {35, 40}, false, 40, middle_score);
        born.resize(std::min(born.size(), n_grown));
        grow_all(born, pair, middle_sizes, false, 80, middle_score);
        if (born.empty() || born.front().scores.total <= best.scores.total) break;
        best = std::move(born.front());
    }
    return best;
}

// Where scores are too close to tell and the maps differ in a limb, the surfaces are bent onto each other for
// each: the wrong map strains them more, and loses by it. A half-turned body is hardly strained, so maps that
// differ as a whole are left to their scores.
void try_out_close_ones(std::vector<Candidate>& candidates, const SampledPair& pair,
                        const MapDistance& distance) {
    constexpr double close = 0.05, weight = 0.2, least_strain = 1e-4, elsewhere = 0.2, limb = 0.5;
    constexpr std::size_t n_tried = 3;
    constexpr RefineOptions quick{
        .last = 80, .last_length = 0.1, .iterations = 8, .rounds = 3, .rounds_if_huge = 1};
    const Candidate& best = candidates.front();
    std::size_t count = 1;
    while (count < std::min(candidates.size(), n_tried) &&
           candidates[count].scores.total > best.scores.total - close &&
           distance.share_beyond(best.maps, candidates[count].maps, elsewhere) < limb)
        ++count;
    if (count < 2) return;
    std::vector<double> strains(count);
    for (std::size_t i = 0; i < count; ++i)
        strains[i] = std::max(refine(pair.a, pair.b, candidates[i], quick).strain, least_strain);
    const double least = *std::min_element(strains.begin(), strains.end());
    for (std::size_t i = 0; i < count; ++i)
        candidates[i].scores.total -= weight * std::log(strains[i] / least);
    std::stable_sort(candidates.begin(), candidates.end(), by_score);
}

}  // namespace

std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count) {
    constexpr std::size_t n_families = 8, n_improved = 3;
    constexpr double least_difference = 0.08, least_in_the_end = 0.05;
    const SampledPair middle(a, b, 600, 0.2), few(a, b, 300, 0.3);
    grow_all(candidates, middle, middle_sizes, false, 80, middle_score);
    const MapDistance distance(middle);
    keep_distinct(candidates, distance, least_difference, std::max(n_families, count));
    const std::vector<Candidate> families(
        candidates.begin(),
        candidates.begin() + static_cast<std::ptrdiff_t>(std::min(n_families, candidates.size())));
    for (std::size_t i = 0; i < std::min(n_improved, candidates.size()); ++i)
        candidates[i] = improved(candidates[i], families, few, middle);
    keep_distinct(candidates, distance, least_difference, count);
    const SampledPair all(a, b, std::max(a.samples.size(), b.samples.size()), 0.15);
    grow_all(candidates, all, {95, 110, 130, 150}, true, 100, fine_score);
    // Grown further, some have become the same map.
    const MapDistance distance_of_all(all);
    keep_distinct(candidates, distance_of_all, least_in_the_end, count);
    try_out_close_ones(candidates, all, distance_of_all);
    return candidates;
}

}  // namespace counterpart::spectral_match
