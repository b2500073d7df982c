// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/final_choice.hpp"

#include "base/parallel.hpp"
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

}  // namespace counterpart::spectral_match
