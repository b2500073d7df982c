// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/selection.hpp"

#include "base/parallel.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// All on the samples of `pair`, grown to `sizes`; best first. Scores are of the functional maps between the
// first `scored_size` functions.
void grow_all(std::vector<Candidate>& candidates, const SampledPair& pair, const std::vector<int>& sizes,
              bool masked, int scored_size, const ScoreWeights& weights, const ProgressRange& progress) {
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        progress.check();
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(pair.points_a, pair.points_b, candidate.functional);
        candidate.maps = zoom_out(pair.points_a, pair.points_b, std::move(candidate.maps), sizes, masked);
        candidate.functional =
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, sizes.back(), masked);
        candidate.scores = score_maps(
            pair, candidate.maps,
            fit_functional_maps(pair.points_a, pair.points_b, candidate.maps, scored_size, false), weights);
    });
    sort_by_score(candidates);
}

SampledPair on_middle_samples(const SampledPair& coarse, const SelectionTuning& tuning) {
    return {coarse.a, coarse.b, tuning.n_samples, tuning.rigidity_radius, coarse.priors};
}

// 3a: the distinct ones on those samples.
void grow_on(const SampledPair& middle, std::vector<Candidate>& candidates, std::size_t count,
             const SelectionTuning& tuning, const ProgressRange& progress) {
    grow_all(candidates, middle, tuning.sizes, false, tuning.sizes.back(), tuning.score, progress);
    keep_distinct(candidates, MapDistance(middle), tuning.distinct, std::max(tuning.n_kept, count));
}

bool is_near_isometry(const std::vector<Candidate>& candidates, const SelectionTuning& tuning) {
    return !candidates.empty() && candidates.front().scores.drift < tuning.near_isometry_drift;
}

// 3b: the finalists on all samples.
std::vector<Candidate> grown_on_all(const SampledPair& coarse, std::vector<Candidate> candidates,
                                    std::size_t count, const SelectionTuning& tuning,
                                    const ProgressRange& progress) {
    while (candidates.size() > tuning.n_least &&
           candidates.back().scores.total < candidates.front().scores.total - tuning.max_behind)
        candidates.pop_back();
    const SampledPair all(coarse.a, coarse.b, all_samples, tuning.final_rigidity_radius, coarse.priors);
    grow_all(candidates, all, tuning.final_sizes, tuning.final_masked, tuning.final_scored_size,
             tuning.final_score, progress);
    // Grown further, some have become the same map.
    keep_distinct(candidates, MapDistance(all), tuning.distinct_finalists, count);
    return candidates;
}

}  // namespace

std::vector<Candidate> select(const SampledPair& coarse, std::vector<Candidate> candidates, std::size_t count,
                              const SelectionTuning& tuning, const ProgressRange& progress) {
    grow_on(on_middle_samples(coarse, tuning), candidates, count, tuning, progress.part(0, 0.5));
    if (!is_near_isometry(candidates, tuning)) return {};
    progress.reach(0.5);
    return grown_on_all(coarse, std::move(candidates), count, tuning, progress);
}

std::vector<Candidate> select_if_decided(const SampledPair& coarse, std::vector<Candidate> candidates,
                                         std::size_t count, const SelectionTuning& tuning,
                                         const ProgressRange& progress) {
    candidates.resize(std::min(candidates.size(), tuning.n_looked_at));
    candidates = select(coarse, std::move(candidates), count, tuning, progress);
    if (candidates.size() < 2) return {};
    const Scores &best = candidates[0].scores, &next = candidates[1].scores;
    const bool is_decided =
        best.drift < tuning.decided_drift && best.total - next.total > tuning.decided_lead;
    return is_decided ? std::move(candidates) : std::vector<Candidate>();
}

}  // namespace counterpart::spectral_match
