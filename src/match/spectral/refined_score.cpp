// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refined_score.hpp"

#include "match/spectral/half_turn_cues.hpp"
#include "match/spectral/round_trips.hpp"

namespace counterpart::spectral_match {
namespace {

// Mean over both shapes of how far vertices end from where they began, and tears.
double damage(const SampledPair& all, const PairedMaps& maps, double most) {
    return (round_trips_and_tears(all.a, all.b, maps).cwiseMin(most).mean() +
            round_trips_and_tears(all.b, all.a, reversed(maps)).cwiseMin(most).mean()) /
           2;
}

}  // namespace

double refined_score(const SampledPair& all, const PairedMaps& maps, const RefinedScoreTuning& tuning) {
    return mean_relief(relief_correlations(all.a, all.b, maps)) +
           tuning.normal_weight * agreement_of_normals(all.a, all.b, maps, tuning.normal_radius) -
           tuning.damage_weight * damage(all, maps, tuning.most_damage) -
           (all.priors.empty() ? 0 : disagreement(all.a, all.b, all.priors, between_samples(all, maps)));
}

}  // namespace counterpart::spectral_match
