// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/edge_table.hpp"

#include <algorithm>
#include <utility>

namespace counterpart::mesh {

EdgeTable::EdgeTable(MeshView mesh) {
    // Counting sort of the sides by smaller vertex, then a sort of each vertex's few sides.
    const auto n = static_cast<std::size_t>(mesh.n_vertices());
    std::vector<std::size_t> begin(n + 1, 0);
    const auto for_each_half_edge = [&](const auto& visit) {
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            if (is_degenerate(mesh, t)) continue;
            for (int c = 0; c < 3; ++c) {
                const Index from = mesh.triangles(t, c), to = mesh.triangles(t, (c + 1) % 3);
                visit(static_cast<std::size_t>(std::min(from, to)),
                      HalfEdge{std::max(from, to), t, static_cast<std::int8_t>(c), from < to});
            }
        }
    };
    for_each_half_edge([&](std::size_t low, const HalfEdge&) { ++begin[low + 1]; });
    for (std::size_t v = 0; v < n; ++v) begin[v + 1] += begin[v];
    half_edges_.resize(begin[n]);
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for_each_half_edge([&](std::size_t low, const HalfEdge& side) { half_edges_[next[low]++] = side; });

    first_.push_back(0);
    for (std::size_t v = 0; v < n; ++v) {
        std::sort(half_edges_.begin() + static_cast<std::ptrdiff_t>(begin[v]),
                  half_edges_.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
                  [](const HalfEdge& a, const HalfEdge& b) {
                      return std::pair(a.high, a.triangle) < std::pair(b.high, b.triangle);
                  });
        for (std::size_t s = begin[v]; s < begin[v + 1]; ++s) {
            if (s == begin[v] || half_edges_[s].high != half_edges_[s - 1].high) {
                low_.push_back(static_cast<Index>(v));
                first_.push_back(0);
            }
            first_.back() = static_cast<std::ptrdiff_t>(s + 1);
        }
    }
}

std::vector<std::pair<Index, Index>> boundary_edges(const EdgeTable& edges) {
    std::vector<std::pair<Index, Index>> found;
    for (Index e = 0; e < edges.n_edges(); ++e)
        if (edges.half_edges(e).size() == 1) found.emplace_back(edges.low(e), edges.high(e));
    return found;
}

}  // namespace counterpart::mesh
