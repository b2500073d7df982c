// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/tears.hpp"

#include "base/to_size.hpp"

#include <counterpart/mesh/measure.hpp>

#include <cmath>

namespace counterpart::surface_match {

std::vector<Index> torn_vertices(MeshView mesh, const Points& places) {
    const double unit = std::sqrt(surface_area(mesh));
    std::vector<char> is_torn(to_size(mesh.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = mesh.triangles(t, c), w = mesh.triangles(t, (c + 1) % 3);
            const double before = (mesh.vertices.row(v) - mesh.vertices.row(w)).norm() / unit;
            if (tear(before, (places.row(v) - places.row(w)).norm()) > torn_apart)
                is_torn[to_size(v)] = is_torn[to_size(w)] = 1;
        }
    }
    std::vector<Index> torn;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (is_torn[to_size(v)] != 0) torn.push_back(v);
    return torn;
}

}  // namespace counterpart::surface_match
