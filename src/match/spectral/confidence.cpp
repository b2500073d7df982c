// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/confidence.hpp"

#include "match/spectral/islands.hpp"
#include "match/spectral/round_trips.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

// Of the map as a whole.
double whole_confidence(double score, const ConfidenceTuning& tuning) {
    return 1 / (1 + std::exp(-(score - tuning.half_score) / tuning.score_width));
}

// For every sample of A the share of those candidates, by likelihood, that take it where the best one does.
Vector agreement(const SampledPair& pair, const std::vector<Candidate>& candidates,
                 const ConfidenceTuning& tuning) {
    const MapDistance distance(pair);
    const Candidate& best = candidates.front();
    Vector agreeing = Vector::Zero(pair.points_a.size()), all = agreeing;
    for (const Candidate& candidate : candidates) {
        const double likelihood = std::exp((candidate.scores.total - best.scores.total) / tuning.temperature);
        all.array() += likelihood;
        for (std::size_t s = 0; s < best.maps.b_from_a.size(); ++s)
            if (distance.on_b(candidate.maps.b_from_a[s], best.maps.b_from_a[s]) < tuning.same_place)
                agreeing[static_cast<Eigen::Index>(s)] += likelihood;
    }
    return agreeing.cwiseQuotient(all);
}

}  // namespace

Vector confidence(const SampledPair& pair, const PairedMaps& maps, const std::vector<Candidate>& candidates,
                  const ConfidenceTuning& tuning) {
    const double whole = whole_confidence(candidates.front().refined_score, tuning);
    const Vector agreeing = agreement(pair, candidates, tuning);
    const Islands islands = find_islands(pair.a, pair.b, maps.b_from_a, tuning.islands);
    Vector result = round_trips_and_tears(pair.a, pair.b, maps);
    for (Eigen::Index v = 0; v < result.size(); ++v) {
        const double doubt = result[v] / tuning.doubt_length;
        result[v] =
            whole * agreeing[pair.a.cell_of_vertex[static_cast<std::size_t>(v)]] * std::exp(-doubt * doubt);
        if (islands.inside[static_cast<std::size_t>(v)] != 0) result[v] *= tuning.island_trust;
    }
    return result;
}

std::string describe(const SampledPair& pair, const Candidate& best, const Candidate& other,
                     const ConfidenceTuning& tuning) {
    if (best.scores.orientation * other.scores.orientation < 0) return "mirrored: left and right exchanged";
    const MapDistance distance(pair);
    const double moved = distance.share_beyond(best.maps, other.maps, tuning.moved);
    if (moved > tuning.turn_share)
        return fmt::format("turned: {:.0f} % of the surface goes elsewhere", 100 * moved);
    if (moved > tuning.limb_share)
        return fmt::format("another limb: {:.0f} % of the surface goes elsewhere", 100 * moved);
    return "a small shift along the surface";
}

}  // namespace counterpart::spectral_match
