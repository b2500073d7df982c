// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/unlike_shapes.hpp"

#include "match/spectral/coarse_shape.hpp"
#include "match/spectral/final_choice.hpp"
#include "match/spectral/lift.hpp"
#include "match/spectral/refined_score.hpp"
#include "match/spectral/refinement.hpp"
#include "match/spectral/rematching.hpp"
#include "match/spectral/rivals.hpp"

#include <utility>

namespace counterpart::spectral_match {
namespace {

// What surrounds a landmark is as far from it on the one body as on the other only if they are alike: maps of
// unlike ones that follow it can lose more elsewhere than they gain. So the winner, and the map that is found
// without landmarks, are refined once more with nothing but the pins to follow, and equation 7 tells.
void add_unguided(std::vector<Candidate>& finalists, const Candidate& unguided, const SampledPair& coarse,
                  const RivalTuning& tuning, const RefinementTuning& refinement,
                  const ProgressRange& progress) {
    const std::vector<Candidate> starts{finalists.front(), unguided};
    for (std::size_t i = 0; i < starts.size(); ++i) {
        Candidate other = starts[i];
        other.follows_landmarks = false;
        other.on_vertices = refine(coarse, other, refinement, progress.step(i, starts.size()));
        other.maps = between_samples(coarse, other.on_vertices);
        other.refined_score = refined_score(coarse, other.on_vertices, tuning.score);
        other.scores.total = starts[0].scores.total + (other.refined_score - starts[0].refined_score);
        finalists.push_back(std::move(other));
    }
    keep_distinct(finalists, MapDistance(coarse), tuning.distinct, finalists.size());
}

// The winner is rematched, and what was taken on the way comes after it. The others are now worse by as much.
void rematch_winner(std::vector<Candidate>& finalists, const SampledPair& coarse, const UnlikeTuning& tuning,
                    const RefinementTuning& refinement, const ProgressRange& progress) {
    const double total = finalists.front().scores.total, before = finalists.front().refined_score;
    std::vector<Candidate> better = rematch_extremities(finalists.front(), coarse, tuning.rematching,
                                                        tuning.rivals.score, refinement, progress);
    const double best = better.front().refined_score;
    for (Candidate& candidate : better) candidate.scores.total = total - (best - candidate.refined_score);
    for (Candidate& other : finalists) other.scores.total -= best - before;
    finalists.erase(finalists.begin());
    finalists.insert(finalists.begin(), better.begin(), better.end());
    keep_distinct(finalists, MapDistance(coarse), tuning.rivals.distinct, finalists.size());
}

}  // namespace

RefinementTuning winners_refinement(const SpectralTuning& tuning) {
    RefinementTuning result = tuning.refinement;
    result.position_weight = tuning.unlike.position_weight;
    result.normal_weight = tuning.unlike.normal_weight;
    return result;
}

std::vector<Candidate> search_unlike(std::vector<Candidate> candidates,
                                     const std::optional<Candidate>& unguided, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress) {
    const CoarseShape a = coarsened(all.a, tuning.unlike.n_coarse, tuning.preparation),
                      b = coarsened(all.b, tuning.unlike.n_coarse, tuning.preparation);
    const Priors priors = coarsened(all.priors, a, b);
    const SampledPair coarse(a.shape, b.shape, all_samples, tuning.final_choice.cues.radius, priors);
    RefinementTuning anew = tuning.refinement;
    anew.goes_on = false;
    std::vector<Candidate> finalists =
        choose_unlike(std::move(candidates), coarse, count, tuning, progress.part(0, 0.4));
    if (finalists.empty()) return {};
    refine_rivals(finalists, coarse, tuning.unlike.rivals, anew, progress.part(0.4, unguided ? 0.6 : 0.65));
    // A single rival still has the map that it was compared by before.
    finalists.front().maps = between_samples(coarse, finalists.front().on_vertices);
    if (unguided)
        add_unguided(finalists, *unguided, coarse, tuning.unlike.rivals, anew, progress.part(0.6, 0.65));
    RefinementTuning of_winner = winners_refinement(tuning);
    of_winner.goes_on = false;
    rematch_winner(finalists, coarse, tuning.unlike, of_winner, progress.part(0.65, 0.95));
    for (Candidate& finalist : finalists) {
        finalist.maps = between_samples(coarse, finalist.on_vertices);
        finalist.on_vertices = lift(a.shape, b.shape, finalist.on_vertices, tuning.refinement, progress);
    }
    progress.reach(1);
    return finalists;
}

}  // namespace counterpart::spectral_match
