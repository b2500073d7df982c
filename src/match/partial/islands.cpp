// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/islands.hpp"

#include "match/surface/tears.hpp"
#include "mesh/disjoint_sets.hpp"

#include <counterpart/mesh/measure.hpp>

#include <algorithm>

namespace counterpart::partial_match {

std::vector<Index> without_islands(std::vector<Index> map, MeshView from, MeshView to,
                                   const IslandTuning& tuning) {
    const auto image = [&](Index v) { return map[static_cast<std::size_t>(v)]; };
    mesh::DisjointSets regions(from.n_vertices()), components(from.n_vertices());
    for (Index t = 0; t < from.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index v = from.triangles(t, c), w = from.triangles(t, (c + 1) % 3);
            components.join(v, w);
            if (image(v) < 0 || image(w) < 0) continue;
            const double before = (from.vertices.row(v) - from.vertices.row(w)).norm(),
                         after = (to.vertices.row(image(v)) - to.vertices.row(image(w))).norm();
            if (surface_match::tear(before, after) <= surface_match::torn_apart) regions.join(v, w);
        }
    const Vector areas = vertex_areas(from);
    Vector area = Vector::Zero(from.n_vertices()), largest = Vector::Zero(from.n_vertices());
    for (Index v = 0; v < from.n_vertices(); ++v)
        if (image(v) >= 0) area[regions.root(v)] += areas[v];
    for (Index v = 0; v < from.n_vertices(); ++v) {
        double& most = largest[components.root(v)];
        most = std::max(most, area[v]);
    }
    for (Index v = 0; v < from.n_vertices(); ++v)
        if (area[regions.root(v)] < tuning.min_share * largest[components.root(v)])
            map[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    return map;
}

}  // namespace counterpart::partial_match
