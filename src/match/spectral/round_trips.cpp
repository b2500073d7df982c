// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/round_trips.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>

namespace counterpart::spectral_match {

Vector round_trips_and_tears(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps) {
    const Adjacency adjacency(a.mesh);
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
        result[v] = cycle + tear;
    }
    return result;
}

}  // namespace counterpart::spectral_match
