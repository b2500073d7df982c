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

}  // namespace

void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress) {
    const std::vector<Candidate*> rivals = rivals_among(finalists, tuning);
    std::vector<double> scores;
    for (Candidate* rival : rivals) {  // one after the other: each takes all threads, and its memory
        rival->on_vertices = refine(all, *rival, refinement, progress.step(scores.size(), rivals.size()));
        scores.push_back(rivals.size() == 1 ? 0 : rival_score(*rival, all, tuning));
    }
    if (rivals.size() <= 1) return;
    const auto best = std::max_element(scores.begin(), scores.end()) - scores.begin();
    const double score = rivals[static_cast<std::size_t>(best)]->scores.total;
    for (Candidate& finalist : finalists) finalist.scores.total = std::min(finalist.scores.total, score);
    for (std::size_t i = 0; i < rivals.size(); ++i) {
        rivals[i]->scores.total = score - (scores[static_cast<std::size_t>(best)] - scores[i]);
        rivals[i]->maps = {between_samples(all.a, all.b, rivals[i]->on_vertices.b_from_a),
                           between_samples(all.b, all.a, rivals[i]->on_vertices.a_from_b)};
    }
    // Of equals the first one stays first: the winner before those whose scores were capped to its.
    std::swap(*rivals.front(), *rivals[static_cast<std::size_t>(best)]);
    keep_distinct(finalists, MapDistance(all), tuning.distinct, finalists.size());
}

}  // namespace counterpart::spectral_match
