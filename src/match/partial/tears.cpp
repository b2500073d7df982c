// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/tears.hpp"

#include <counterpart/mesh/measure.hpp>

#include <cmath>

namespace counterpart::partial_match {

std::vector<Index> torn_vertices(MeshView mesh, const Points& places, const TearTuning& tuning) {
    const double unit = std::sqrt(surface_area(mesh));
    std::vector<char> is_torn(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = mesh.triangles(t, c), w = mesh.triangles(t, (c + 1) % 3);
            const double before = (mesh.vertices.row(v) - mesh.vertices.row(w)).norm() / unit;
            if ((places.row(v) - places.row(w)).norm() > tuning.length + tuning.stretch * before)
                is_torn[static_cast<std::size_t>(v)] = is_torn[static_cast<std::size_t>(w)] = 1;
        }
    }
    std::vector<Index> torn;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (is_torn[static_cast<std::size_t>(v)] != 0) torn.push_back(v);
    return torn;
}

}  // namespace counterpart::partial_match
