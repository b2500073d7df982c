// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/final_choice.hpp"

#include "base/parallel.hpp"
#include "match/spectral/refined_score.hpp"
#include "match/spectral/refinement.hpp"

#include <algorithm>
#include <numeric>

namespace counterpart::spectral_match {
namespace {

// Near 1 for the same shape in the same pose.
double total_score(const Scores& selection, const Cues& cues, const CueTuning& tuning) {
    return (selection.total + tuning.relief_weight * mean_relief(cues.relief) -
            tuning.residual_weight * cues.residual - tuning.wring_weight * cues.wring -
            tuning.drift_weight * selection.drift) /
           (1 + tuning.relief_weight);
}

// Between all samples, with the scores of the selection.
void measure(Candidate& candidate, const SampledPair& all, const FinalChoiceTuning& tuning) {
    candidate.scores =
        score_maps(all, candidate.maps,
                   fit_functional_maps(all.points_a, all.points_b, candidate.maps, tuning.scored_size, false),
                   tuning.score);
    candidate.cues = measure_cues(all, candidate.on_vertices, tuning.cues);
    candidate.scores.total = total_score(candidate.scores, candidate.cues, tuning.cues);
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
        finalist.disagreement = disagreement(all.a, all.b, all.priors, finalist.maps);
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
                                     std::size_t count, const FinalChoiceTuning& tuning,
                                     const RefinedScoreTuning& score, const ProgressRange& progress) {
    while (candidates.size() > count &&
           candidates.back().scores.total < candidates.front().scores.total - tuning.close_candidate)
        candidates.pop_back();
    std::vector<double> scores(candidates.size());
    parallel_for(candidates.size(), 1, [&](std::size_t i) {
        Candidate& candidate = candidates[i];
        candidate.maps = match_points(all.points_a, all.points_b, candidate.functional);
        candidate.disagreement = disagreement(all.a, all.b, all.priors, candidate.maps);
        candidate.was_tried = true;
        candidate.on_vertices = refine(all, candidate, tuning.refinement, progress);
        candidate.maps = between_samples(all, candidate.on_vertices);
        scores[i] = refined_score(all, candidate, score);
    });
    std::vector<std::size_t> order(candidates.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return scores[i] > scores[j]; });
    order.resize(std::min(order.size(), std::max(count, tuning.n_unlike)));
    std::vector<Candidate> finalists;
    for (const std::size_t i : order) finalists.push_back(std::move(candidates[i]));
    parallel_for(finalists.size(), 1, [&](std::size_t i) { measure(finalists[i], all, tuning); });
    // The first is as good as its score says, the others worse by as much as they are by equation 7.
    for (std::size_t i = 1; i < finalists.size(); ++i)
        finalists[i].scores.total = finalists[0].scores.total - (scores[order[0]] - scores[order[i]]);
    return finalists;
}

}  // namespace counterpart::spectral_match
