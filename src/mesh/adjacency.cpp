// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>

namespace counterpart {

Adjacency::Adjacency(MeshView mesh) : first_(static_cast<std::size_t>(mesh.n_vertices()) + 1, 0) {
    const auto n = static_cast<std::size_t>(mesh.n_vertices());
    // Every corner contributes its two other corners; counting sort by vertex, then sort and deduplicate each
    // row.
    std::vector<Index> begin(n + 1, 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) begin[static_cast<std::size_t>(mesh.triangles(t, c)) + 1] += 2;
    for (std::size_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
    std::vector<Index> raw(static_cast<std::size_t>(begin[n])), cursor(begin.begin(), begin.end() - 1);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            Index& next = cursor[static_cast<std::size_t>(mesh.triangles(t, c))];
            raw[static_cast<std::size_t>(next++)] = mesh.triangles(t, (c + 1) % 3);
            raw[static_cast<std::size_t>(next++)] = mesh.triangles(t, (c + 2) % 3);
        }
    }
    neighbors_.reserve(raw.size() / 2 + 16);
    for (std::size_t v = 0; v < n; ++v) {
        const auto row = raw.begin() + begin[v], row_end = raw.begin() + begin[v + 1];
        std::sort(row, row_end);
        for (auto it = row, last = std::unique(row, row_end); it != last; ++it)
            if (*it != static_cast<Index>(v)) neighbors_.push_back(*it);
        first_[v + 1] = static_cast<Index>(neighbors_.size());
    }
}

bool Adjacency::has_edge(Index a, Index b) const {
    const auto row = neighbors(a);
    return std::binary_search(row.begin(), row.end(), b);
}

Components connected_components(const Adjacency& adjacency) {
    Components result;
    result.of_vertex.assign(static_cast<std::size_t>(adjacency.n_vertices()), -1);
    std::vector<Index> stack;
    for (Index seed = 0; seed < adjacency.n_vertices(); ++seed) {
        if (result.of_vertex[static_cast<std::size_t>(seed)] >= 0) continue;
        stack.push_back(seed);
        result.of_vertex[static_cast<std::size_t>(seed)] = result.count;
        while (!stack.empty()) {
            const Index v = stack.back();
            stack.pop_back();
            for (const Index w : adjacency.neighbors(v)) {
                if (result.of_vertex[static_cast<std::size_t>(w)] >= 0) continue;
                result.of_vertex[static_cast<std::size_t>(w)] = result.count;
                stack.push_back(w);
            }
        }
        ++result.count;
    }
    return result;
}

}  // namespace counterpart
