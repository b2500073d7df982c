// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>
#include <vector>

namespace counterpart {

/// A triangle that names a vertex twice.
inline bool is_degenerate(const TriangleMesh& mesh, Index t) {
    const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
    return a == b || b == c || c == a;
}

/// The undirected edges of a mesh in lexicographic order, each with its triangles. Degenerate triangles have
/// no edges.
class EdgeTable {
  public:
    /// One triangle at an edge: the edge leads from corner `corner` of triangle `triangle` to the next
    /// corner.
    struct Side {
        Index high;  ///< the edge's larger vertex
        Index triangle;
        std::int8_t corner;
        bool forward;  ///< the triangle runs from the smaller to the larger vertex
    };

    /// O(F log valence).
    explicit EdgeTable(const TriangleMesh& mesh);

    Index n_edges() const { return static_cast<Index>(low_.size()); }
    Index low(Index edge) const { return low_[static_cast<std::size_t>(edge)]; }
    Index high(Index edge) const { return sides(edge)[0].high; }
    /// At least one, by triangle.
    std::span<const Side> sides(Index edge) const {
        const auto e = static_cast<std::size_t>(edge);
        return {sides_.data() + first_[e], static_cast<std::size_t>(first_[e + 1] - first_[e])};
    }

  private:
    std::vector<Side> sides_;
    std::vector<std::ptrdiff_t> first_;  // edge e has sides_[first_[e] .. first_[e + 1])
    std::vector<Index> low_;
};

}  // namespace counterpart
