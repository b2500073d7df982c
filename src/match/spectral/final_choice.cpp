// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/final_choice.hpp"

#include "base/parallel.hpp"
#include "match/spectral/refined_score.hpp"
#include "match/spectral/refinement.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// Near 1 for the same shape in the same pose.
double total_score(const Scores& selection, const Cues& cues, const CueTuning& tuning) {
    return (selection.total + tuning.relief_weight * mean_relief(cues.relief) -
            tuning.residual_weight * cues.residual - tuning.wring_weight * cues.wring -
            tuning.drift_weight * selection.drift) /
           (1 + tuning.relief_weight);
}

// A refined map, by the score of the selection and by its cues.
void measure(Candidate& candidate, const SampledPair& all, const SpectralTuning& tuning) {
    candidate.scores = score_maps(all, candidate.maps,
                                  fit_functional_maps(all.points_a, all.points_b, candidate.maps,
                                                      tuning.selection.final_scored_size, false),
                                  tuning.selection.final_score);
    candidate.cues = measure_cues(all, candidate.on_vertices, tuning.final_choice.cues);
    candidate.scores.total = total_score(candidate.scores, candidate.cues, tuning.final_choice.cues);
}

}  // namespace

void choose_best(std::vector<Candidate>& finalists, const SampledPair& all, const FinalChoiceTuning& tuning,
                 const ProgressRange& progress) {
    finalists.resize(std::min(finalists.size(), tuning.n_tried));
    if (finalists.empty()) return;
    const double least = finalists.front().scores.total - tuning.close_score;
    const auto n_close = std::count_if(finalists.begin(), finalists.end(), [&](const Candidate& finalist) {
        return finalist.scores.total >= least;
    });
    RefinementTuning none = tuning.refinement;
    none.n_rounds = none.n_rounds_if_huge = 0;
    parallel_for(finalists.size(), 1, [&](std::size_t i) {
        Candidate& finalist = finalists[i];
        finalist.was_tried = static_cast<std::ptrdiff_t>(i) < n_close;
        finalist.on_vertices = refine(all, finalist, finalist.was_tried ? tuning.refinement : none, progress);
        finalist.cues = measure_cues(all, finalist.on_vertices, tuning.cues);
        finalist.scores.total = total_score(finalist.scores, finalist.cues, tuning.cues);
    });
    // Those that were not refined cannot win.
    const auto is_worse = [](const Candidate& x, const Candidate& y) {
        return x.scores.total < y.scores.total;
    };
    const double best =
        std::max_element(finalists.begin(), finalists.begin() + n_close, is_worse)->scores.total;
    for (auto other = finalists.begin() + n_close; other != finalists.end(); ++other)
        other->scores.total = std::min(other->scores.total, best);
    sort_by_score(finalists);
}

std::vector<Candidate> choose_unlike(std::vector<Candidate> candidates, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress) {
    const FinalChoiceTuning& choice = tuning.final_choice;
    while (candidates.size() > count &&
           candidates.back().scores.total < candidates.front().scores.total - tuning.unlike.close_candidate)
        candidates.pop_back();
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(all.points_a, all.points_b, candidate.functional);
        candidate.was_tried = true;
        candidate.on_vertices = refine(all, candidate, choice.refinement, progress);
        candidate.maps = between_samples(all, candidate.on_vertices);
        candidate.refined_score = refined_score(all, candidate.on_vertices, tuning.unlike.rivals.score);
    });
    for (Candidate& candidate : candidates) candidate.scores.total = candidate.refined_score;
    // Many have become one map, which would be refined again and again.
    const RivalTuning& rivals = tuning.unlike.rivals;
    keep_distinct(candidates, MapDistance(all), rivals.distinct, std::max(count, rivals.n_refined));
    for (Candidate& candidate : candidates) measure(candidate, all, tuning);
    // The first is as good as its score says, the others worse by as much as they are by equation 7.
    for (Candidate& candidate : candidates)
        candidate.scores.total =
            candidates.front().scores.total - (candidates.front().refined_score - candidate.refined_score);
    return candidates;
}

}  // namespace counterpart::spectral_match
