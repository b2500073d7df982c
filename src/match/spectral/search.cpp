// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/search.hpp"

#include "match/spectral/candidates.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/selection.hpp"
#include "match/spectral/unlike_shapes.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// Unlike shapes, from the first candidates on. `all` as of the final choice.
std::vector<Candidate> search_anew(const SampledPair& all, std::size_t count, const SpectralTuning& tuning,
                                   const ProgressRange& progress) {
    const CandidateTuning& candidates = tuning.candidates;
    const SampledPair coarse(all.a, all.b, candidates.n_samples, candidates.rigidity_radius, all.priors);
    return search_unlike(vary_candidates(coarse, start_candidates(coarse, candidates, progress.part(0, 0.1)),
                                         candidates, progress.part(0.1, 0.3)),
                         {}, all, count, tuning, progress.part(0.3, 1));
}

void add_to_scores(std::vector<Candidate>& maps, double difference) {
    for (Candidate& map : maps) map.scores.total += difference;
}

// Which map is found depends on chance where shapes are very unlike. Where it fits badly, maps are sought
// from B to A as well. The better best one by equation 7 keeps its score, the other is worse by as much as
// that says, so that exchanging A and B changes nothing.
void add_reverse_search(std::vector<Candidate>& finalists, const SampledPair& all, std::size_t count,
                        const SpectralTuning& tuning, const ProgressRange& progress) {
    if (!finalists.empty() && finalists.front().refined_score < tuning.unlike.doubtful_score) {
        const Priors priors = reversed(all.priors);
        std::vector<Candidate> others = search_anew(
            {all.b, all.a, all_samples, tuning.final_choice.cues.radius, priors}, count, tuning, progress);
        const Candidate &best = finalists.front(), &other = others.front();
        const double gain = other.refined_score - best.refined_score,
                     difference = other.scores.total - best.scores.total;
        if (gain > 0)
            add_to_scores(finalists, difference - gain);
        else
            add_to_scores(others, gain - difference);
        for (Candidate& map : others) finalists.push_back(reversed(std::move(map)));
        keep_distinct(finalists, MapDistance(all), tuning.unlike.rivals.distinct, finalists.size());
    }
    progress.reach(1);
}

// The best map of unlike shapes that is found without landmarks.
Candidate find_unguided(const SampledPair& all, const SpectralTuning& tuning, const ProgressRange& progress) {
    Priors priors = all.priors;
    priors.landmarks.clear();
    const SampledPair unguided(all.a, all.b, all_samples, tuning.final_choice.cues.radius, priors);
    std::vector<Candidate> found = search_anew(unguided, 1, tuning, progress.part(0, 0.5));
    add_reverse_search(found, unguided, 1, tuning, progress.part(0.5, 1));
    return found.front();
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
            unguided = find_unguided(found.all, tuning, progress.part(0.4, 0.7));
        finalists = search_unlike(std::move(candidates), unguided, found.all, n_asked, tuning,
                                  unguided ? progress.part(0.7, 1) : progress.part(0.4, 0.7));
        if (!unguided) add_reverse_search(finalists, found.all, n_asked, tuning, progress.part(0.7, 1));
        found.rivals.n_refined = 1;
        found.rivals.n_pull_rounds = tuning.unlike.rivals.n_pull_rounds;
        if (!finalists.empty() && finalists.front().was_rematched)
            found.refinement = winners_refinement(tuning);
    }
    watch.lap("final choice");
    return found;
}

}  // namespace counterpart::spectral_match
