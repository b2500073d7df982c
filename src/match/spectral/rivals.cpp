// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rivals.hpp"

#include "base/parallel.hpp"
#include "match/spectral/refinement.hpp"
#include "match/spectral/round_trips.hpp"

#include <algorithm>
#include <numeric>

namespace counterpart::spectral_match {
namespace {

// Mean over both shapes of how far vertices end from where they began, and tears.
double damage(const SampledPair& all, const PairedMaps& maps, double most) {
    const PairedMaps reversed{maps.a_from_b, maps.b_from_a};
    return (round_trips_and_tears(all.a, all.b, maps).cwiseMin(most).mean() +
            round_trips_and_tears(all.b, all.a, reversed).cwiseMin(most).mean()) /
           2;
}

// Equation 7.
double rival_score(const Candidate& rival, const SampledPair& all, const RivalTuning& tuning) {
    const std::array<double, 4> relief = relief_correlations(all.a, all.b, rival.on_vertices);
    return rival.scores.total +
           tuning.relief_weight * std::accumulate(relief.begin(), relief.end(), 0.0) / relief.size() -
           tuning.damage_weight * damage(all, rival.on_vertices, tuning.most_damage);
}

}  // namespace

void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress) {
    const double least = finalists.front().scores.total - tuning.close_score;
    const auto is_rival = [&](const Candidate& finalist) { return finalist.scores.total >= least; };
    const auto n_rivals =
        std::clamp<std::ptrdiff_t>(std::count_if(finalists.begin(), finalists.end(), is_rival), 1,
                                   static_cast<std::ptrdiff_t>(tuning.n_refined));
    std::vector<double> scores(static_cast<std::size_t>(n_rivals));
    parallel_for(scores.size(), 1, [&](std::size_t i) {
        finalists[i].on_vertices = refine(all, finalists[i], refinement, progress);
        if (n_rivals > 1) scores[i] = rival_score(finalists[i], all, tuning);
    });
    const auto best = std::max_element(scores.begin(), scores.end()) - scores.begin();
    std::rotate(finalists.begin(), finalists.begin() + best, finalists.begin() + best + 1);
    for (Candidate& other : finalists)
        other.scores.total = std::min(other.scores.total, finalists.front().scores.total);
}

}  // namespace counterpart::spectral_match
