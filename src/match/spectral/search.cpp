// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/search.hpp"

#include "match/spectral/candidates.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/selection.hpp"
#include "match/spectral/unlike_shapes.hpp"

#include <algorithm>
#include <optional>

namespace counterpart::spectral_match {
namespace {

// The best map of unlike shapes that is found without landmarks.
Candidate find_unguided(const PreparedShape& a, const PreparedShape& b, Priors priors,
                        const SpectralTuning& tuning, const ProgressRange& progress) {
    priors.landmarks.clear();
    const SampledPair coarse(a, b, tuning.candidates.n_samples, tuning.candidates.rigidity_radius, priors);
    const SampledPair all(a, b, all_samples, tuning.final_choice.cues.radius, priors);
    return search_unlike(
               vary_candidates(coarse, start_candidates(coarse, tuning.candidates, progress.part(0, 0.1)),
                               tuning.candidates, progress.part(0.1, 0.3)),
               {}, all, 1, tuning, progress.part(0.3, 1))
        .front();
}

}  // namespace

Search search(const PreparedShape& a, const PreparedShape& b, const Priors& priors,
              std::size_t n_alternatives, const SpectralTuning& tuning, const ProgressRange& progress,
              Stopwatch& watch) {
    const std::size_t n_asked = n_alternatives + 1,
                      n_finalists = std::max(tuning.selection.n_finalists, n_asked);
    FinalChoiceTuning choice = tuning.final_choice;
    choice.n_tried = std::max(choice.n_tried, n_asked);
    Search found{{a, b, all_samples, choice.cues.radius, priors}, {}, tuning.rivals, tuning.refinement};
    std::vector<Candidate>& finalists = found.finalists;
    const SampledPair coarse(a, b, tuning.candidates.n_samples, tuning.candidates.rigidity_radius, priors);

    std::vector<Candidate> candidates = start_candidates(coarse, tuning.candidates, progress.part(0, 0.1));
    watch.lap("candidates");
    finalists = select_if_decided(coarse, candidates, n_finalists, tuning.selection, progress.part(0.1, 0.2));
    watch.lap("selection");
    if (!finalists.empty()) {  // what is decided needs no second look
        choice.close_score = 0;
        found.rivals.n_refined = 1;
    } else {
        candidates =
            vary_candidates(coarse, std::move(candidates), tuning.candidates, progress.part(0.2, 0.4));
        watch.lap("candidates");
        finalists = select(coarse, candidates, n_finalists, tuning.selection, progress.part(0.4, 0.6));
        watch.lap("selection");
    }
    if (!finalists.empty()) {
        choose_best(finalists, found.all, choice, progress.part(0.6, 1));
    } else {
        std::optional<Candidate> unguided;
        const std::size_t n_pins = priors.pins().size();
        if (n_pins > 0 && n_pins <= tuning.unlike.max_unguided_pins)
            unguided = find_unguided(a, b, priors, tuning, progress.part(0.4, 0.7));
        finalists = search_unlike(std::move(candidates), unguided, found.all, n_asked, tuning,
                                  progress.part(unguided ? 0.7 : 0.4, 1));
        found.rivals.n_refined = 1;
        found.rivals.n_pull_rounds = tuning.unlike.rivals.n_pull_rounds;
        if (!finalists.empty() && finalists.front().was_rematched)
            found.refinement = winners_refinement(tuning);
    }
    watch.lap("final choice");
    return found;
}

}  // namespace counterpart::spectral_match
