// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/tears.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>

namespace counterpart::partial_match {

Tears find_tears(const Surface& part, const Surface& whole, const std::vector<Index>& image,
                 const TearTuning& tuning) {
    const auto place = [&](Index v) {
        return whole.mesh.vertices.row(std::max(image[static_cast<std::size_t>(v)], Index{0}));
    };
    std::vector<char> torn(static_cast<std::size_t>(part.mesh.n_vertices()), 0);
    std::vector<Index> kept;
    for (Index t = 0; t < part.mesh.n_triangles(); ++t) {
        bool is_whole = true;
        for (int c = 0; c < 3; ++c) {
            const Index v = part.mesh.triangles(t, c), w = part.mesh.triangles(t, (c + 1) % 3);
            const double before = (part.mesh.vertices.row(v) - part.mesh.vertices.row(w)).norm();
            if ((place(v) - place(w)).norm() <= tuning.length + tuning.stretch * before) continue;
            is_whole = false;
            torn[static_cast<std::size_t>(v)] = torn[static_cast<std::size_t>(w)] = 1;
        }
        if (is_whole) kept.push_back(t);
    }
    Tears tears;
    for (Index v = 0; v < part.mesh.n_vertices(); ++v)
        if (torn[static_cast<std::size_t>(v)] != 0) tears.vertices.push_back(v);
    tears.mesh = {part.mesh.vertices, part.mesh.triangles(kept, Eigen::all)};
    return tears;
}

Index euler_characteristic(MeshView mesh) {
    return mesh.n_vertices() - Adjacency(mesh).n_edges() + mesh.n_triangles();
}

}  // namespace counterpart::partial_match
