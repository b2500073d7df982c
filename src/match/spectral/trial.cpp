// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/trial.hpp"

#include "match/spectral/refinement.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::spectral_match {
namespace {

// How many of the finalists are too close to the best to tell.
std::size_t count_close(const std::vector<Candidate>& finalists, const MapDistance& distance,
                        const TrialTuning& tuning) {
    const Candidate& best = finalists.front();
    std::size_t count = 1;
    while (count < std::min(finalists.size(), tuning.n_tried) &&
           finalists[count].scores.total > best.scores.total - tuning.close_score &&
           distance.share_beyond(best.maps, finalists[count].maps, tuning.moved) < tuning.max_moved_share)
        ++count;
    return count;
}

}  // namespace

void run_trials(std::vector<Candidate>& finalists, const SampledPair& all, const TrialTuning& tuning,
                const ProgressRange& progress) {
    const std::size_t count = count_close(finalists, MapDistance(all), tuning);
    if (count < 2) return;
    std::vector<double> strains(count);
    for (std::size_t i = 0; i < count; ++i)
        strains[i] =
            std::max(refine(all.a, all.b, finalists[i], tuning.refinement, progress.step(i, count)).strain,
                     tuning.min_strain);
    const double least = *std::min_element(strains.begin(), strains.end());
    for (std::size_t i = 0; i < count; ++i)
        finalists[i].scores.total -= tuning.strain_weight * std::log(strains[i] / least);
    sort_by_score(finalists);
}

}  // namespace counterpart::spectral_match
