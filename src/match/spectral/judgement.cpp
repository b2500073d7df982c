// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/judgement.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace counterpart::spectral_match {

Vector confidence(const Shape& a, const Shape& b, const PairedMaps& maps, double score) {
    const Adjacency adjacency(a.mesh);
    const double whole = 1 / (1 + std::exp(-(score - 0.62) / 0.1));
    Vector result(a.mesh.n_vertices());
    for (Index v = 0; v < a.mesh.n_vertices(); ++v) {
        const Index image = maps.b_from_a[static_cast<std::size_t>(v)];
        const Index back = maps.a_from_b[static_cast<std::size_t>(image)];
        const double cycle = (a.mesh.vertices.row(v) - a.mesh.vertices.row(back)).norm();
        double tear = 0;
        for (const Index w : adjacency.neighbors(v)) {
            const double before = (a.mesh.vertices.row(v) - a.mesh.vertices.row(w)).norm();
            const double after =
                (b.mesh.vertices.row(image) - b.mesh.vertices.row(maps.b_from_a[static_cast<std::size_t>(w)]))
                    .norm();
            tear = std::max(tear, after - 2 * before);
        }
        const double doubt = (cycle + tear) / 0.08;
        result[v] = whole * std::exp(-doubt * doubt);
    }
    return result;
}

std::string describe(const SampledPair& pair, const Candidate& best, const Candidate& other) {
    if (best.scores.orientation * other.scores.orientation < 0) return "mirrored: left and right exchanged";
    const MapDistance distance(pair);
    constexpr double far = 0.2;
    const double moved = distance.share_beyond(best.maps, other.maps, far);
    if (moved > 0.6) return fmt::format("turned: {:.0f} % of the surface goes elsewhere", 100 * moved);
    if (moved > 0.02) return fmt::format("another limb: {:.0f} % of the surface goes elsewhere", 100 * moved);
    return "a small shift along the surface";
}

}  // namespace counterpart::spectral_match
