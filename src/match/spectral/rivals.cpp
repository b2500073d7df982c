// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rivals.hpp"

#include "match/spectral/refinement.hpp"
#include "match/spectral/round_trips.hpp"

#include <algorithm>

namespace counterpart::spectral_match {
namespace {

// Mean over both shapes of how far vertices end from where they began, and tears.
double damage(const SampledPair& all, const PairedMaps& maps, double most) {
    const PairedMaps reversed{maps.a_from_b, maps.b_from_a};
    return (round_trips_and_tears(all.a, all.b, maps).cwiseMin(most).mean() +
            round_trips_and_tears(all.b, all.a, reversed).cwiseMin(most).mean()) /
           2;
}

// Equation 7. Landmarks hold in a refined map even where the limb around them is wrong: what was asked for
// counts as the map was before.
double rival_score(const Candidate& rival, const SampledPair& all, const RivalTuning& tuning) {
    return rival.scores.total +
           tuning.relief_weight * mean_relief(relief_correlations(all.a, all.b, rival.on_vertices)) -
           tuning.damage_weight * damage(all, rival.on_vertices, tuning.most_damage) -
           disagreement(all.a, all.b, all.priors, rival.maps);
}

std::vector<Candidate*> rivals_among(std::vector<Candidate>& finalists, const RivalTuning& tuning) {
    const double least = finalists.front().scores.total - tuning.close_score;
    std::vector<Candidate*> rivals;
    for (Candidate& finalist : finalists)
        if (rivals.size() < tuning.n_refined && finalist.was_tried && finalist.scores.total >= least)
            rivals.push_back(&finalist);
    return rivals;
}

// The sample nearest to the image of each sample.
std::vector<Index> between_samples(const PreparedShape& a, const PreparedShape& b,
                                   const std::vector<Index>& b_from_a) {
    std::vector<Index> result;
    for (const Index v : a.samples)
        result.push_back(b.cell_of_vertex[static_cast<std::size_t>(b_from_a[static_cast<std::size_t>(v)])]);
    return result;
}

PairedMaps between_samples(const SampledPair& all, const PairedMaps& on_vertices) {
    return {between_samples(all.a, all.b, on_vertices.b_from_a),
            between_samples(all.b, all.a, on_vertices.a_from_b)};
}

// Once more from stiff to pliable, from where the last refinement ended, for as long as equation 7 gains.
void refine_again(Candidate& best, double score, int n_repeats, const SampledPair& all,
                  const RivalTuning& tuning, const RefinementTuning& refinement,
                  const ProgressRange& progress) {
    for (int repeat = 0; repeat < n_repeats; ++repeat) {
        Candidate next = best;
        next.maps = between_samples(all, best.on_vertices);
        next.on_vertices =
            refine(all, next, refinement,
                   progress.step(static_cast<std::size_t>(repeat), static_cast<std::size_t>(n_repeats)));
        next.maps = best.maps;  // what contradicts priors is told by the map as it was
        const double next_score = rival_score(next, all, tuning);
        if (next_score <= score) break;
        best.on_vertices = std::move(next.on_vertices);
        score = next_score;
    }
}

}  // namespace

void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress) {
    const std::vector<Candidate*> rivals = rivals_among(finalists, tuning);
    if (rivals.empty()) return;  // no score is a number
    const ProgressRange once = progress.part(0, 0.5);
    std::vector<double> scores;
    for (Candidate* rival : rivals) {  // one after the other: each takes all threads, and its memory
        rival->on_vertices = refine(all, *rival, refinement, once.step(scores.size(), rivals.size()));
        scores.push_back(rival_score(*rival, all, tuning));
    }
    const auto best = at(std::max_element(scores.begin(), scores.end()) - scores.begin());
    Candidate& winner = *rivals[best];
    const double score = winner.scores.total;
    // A near isometry has gone on from its brief refinement already, and has nowhere to go.
    if (winner.scores.drift >= refinement.continued_drift)
        refine_again(winner, scores[best], tuning.n_repeats, all, tuning, refinement, progress.part(0.5, 1));
    progress.reach(1);
    if (rivals.size() == 1) return;
    for (Candidate& finalist : finalists) finalist.scores.total = std::min(finalist.scores.total, score);
    for (std::size_t i = 0; i < rivals.size(); ++i) {
        rivals[i]->scores.total = score - (scores[best] - scores[i]);
        rivals[i]->maps = between_samples(all, rivals[i]->on_vertices);
    }
    // Of equals the first one stays first: the winner before those whose scores were capped to its.
    std::swap(*rivals.front(), winner);
    keep_distinct(finalists, MapDistance(all), tuning.distinct, finalists.size());
}

}  // namespace counterpart::spectral_match
