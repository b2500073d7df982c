// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/beyond.hpp"

#include "mesh/edge_table.hpp"

#include <counterpart/mesh/adjacency.hpp>

namespace counterpart::differences {
namespace {

std::vector<char> on_boundary(MeshView mesh) {
    std::vector<char> result(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(mesh)))
        result[static_cast<std::size_t>(v)] = result[static_cast<std::size_t>(w)] = 1;
    return result;
}

}  // namespace

std::vector<char> beyond_target(const VertexMap& target_from_source, MeshView source, MeshView target) {
    const std::vector<char> source_ends = on_boundary(source), target_ends = on_boundary(target);
    const Adjacency adjacency(source);
    std::vector<char> beyond(source_ends.size(), 0);
    std::vector<Index> open;
    const auto add = [&](Index v) {
        if (target_from_source[v] != VertexMap::unmatched || beyond[static_cast<std::size_t>(v)] != 0) return;
        beyond[static_cast<std::size_t>(v)] = 1;
        open.push_back(v);
    };
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index image = target_from_source[v];
        if (image == VertexMap::unmatched || source_ends[static_cast<std::size_t>(v)] != 0 ||
            target_ends[static_cast<std::size_t>(image)] == 0)
            continue;
        for (const Index w : adjacency.neighbors(v)) add(w);
    }
    while (!open.empty()) {
        const Index v = open.back();
        open.pop_back();
        for (const Index w : adjacency.neighbors(v)) add(w);
    }
    return beyond;
}

}  // namespace counterpart::differences
