// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/confidence.hpp"

#include "match/spectral/islands.hpp"
#include "match/surface/trust.hpp"

#include <cmath>

#include <fmt/format.h>

namespace counterpart::spectral_match {
namespace {

// For every sample of A the share of the maps, by likelihood, that take it where the best one does.
Vector agreement(const Level& whole, const Polished& found, const ConfidenceTuning& tuning) {
    const MapDistance distance(whole.pair);
    const std::vector<Index>& best = found.best.maps.b_from_a;
    Vector agreeing = Vector::Ones(whole.pair.points_a.size()), all = agreeing;
    for (const RunnerUp& other : found.runners_up) {
        const double likelihood = std::exp(-other.behind / tuning.temperature);
        all.array() += likelihood;
        for (std::size_t s = 0; s < best.size(); ++s)
            if (distance.on_b(other.map.maps.b_from_a[s], best[s]) < tuning.same_place)
                agreeing[static_cast<Eigen::Index>(s)] += likelihood;
    }
    return agreeing.cwiseQuotient(all);
}

double orientation(const SampledPair& pair, const PairedMaps& maps, int size) {
    return orientation_score(pair.a.orientation, pair.b.orientation,
                             fit_functional_maps(pair.points_a, pair.points_b, maps, size, false).a_from_b);
}

}  // namespace

Vector confidence(const Level& whole, const Polished& found) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    const double trust = surface_match::trust(found.best.rank(), tuning.half_score, tuning.score_width);
    const Vector agreeing = agreement(whole, found, tuning);
    const Islands islands =
        find_islands(whole.a, whole.b, found.best.on_vertices.b_from_a, whole.tuning.refinement.islands);
    Vector result = round_trips_and_tears(whole.a, whole.b, found.best.on_vertices);
    for (Index v = 0; v < whole.a.shape.mesh.n_vertices(); ++v) {
        result[v] = trust * agreeing[whole.a.cells.of_vertex(v)] *
                    surface_match::trust_at(result[v], tuning.doubt_length);
        if (islands.inside[at(v)] != 0) result[v] *= tuning.island_trust;
    }
    return result;
}

Departure departure(const Level& whole, const Map& best, const Map& other) {
    const ConfidenceTuning& tuning = whole.tuning.confidence;
    const int size = whole.tuning.candidates.last_size;
    const double moved = MapDistance(whole.pair).share_beyond(best.maps, other.maps, tuning.moved);
    if (orientation(whole.pair, best.maps, size) * orientation(whole.pair, other.maps, size) < 0)
        return {"mirrored: left and right exchanged", 1};
    if (moved > tuning.turn_share)
        return {fmt::format("turned: {:.0f} % of the surface goes elsewhere", 100 * moved), moved};
    if (moved > tuning.part_share)
        return {fmt::format("another part: {:.0f} % of the surface goes elsewhere", 100 * moved), moved};
    return {"a small shift along the surface", moved};
}

}  // namespace counterpart::spectral_match
