// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <utility>
#include <vector>

namespace counterpart::mesh {

/// Whether a triangle has a repeated vertex.
inline bool is_degenerate(MeshView mesh, Index t) {
    const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    return a == b || b == c || c == a;
}

/// The undirected edges of a mesh in lexicographic order, each with its triangles. Degenerate triangles have
/// no edges.
class EdgeTable {
  public:
    /// An edge as a side of one of its triangles, from corner `corner` of `triangle` to the next corner.
    struct HalfEdge {
        Index high;  ///< the edge's larger vertex
        Index triangle;
        std::int8_t corner;
        bool forward;  ///< whether it leads from the smaller to the larger vertex
    };

    /// O(F log valence).
    explicit EdgeTable(MeshView mesh);

    Index n_edges() const { return static_cast<Index>(low_.size()); }
    Index low(Index edge) const { return low_[static_cast<std::size_t>(edge)]; }
    Index high(Index edge) const { return half_edges(edge)[0].high; }
    /// At least one, sorted by triangle.
    std::span<const HalfEdge> half_edges(Index edge) const {
        const auto e = static_cast<std::size_t>(edge);
        return {half_edges_.data() + first_[e], static_cast<std::size_t>(first_[e + 1] - first_[e])};
    }

  private:
    std::vector<HalfEdge> half_edges_;
    std::vector<std::ptrdiff_t> first_;  // edge e has half_edges_[first_[e] .. first_[e + 1])
    std::vector<Index> low_;
};

/// The edges with one triangle, as pairs of vertices, the smaller first.
std::vector<std::pair<Index, Index>> boundary_edges(const EdgeTable& edges);

}  // namespace counterpart::mesh
