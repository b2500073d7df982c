// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A triangle mesh as a combinatorial map: what is left of it when positions and numbering are forgotten.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace counterpart {

/// A half-edge of triangle t, from corner c to corner c + 1, with the direction d in which its triangle is
/// gone around: 8 t + 2 c + d. With d = 1 it runs from corner c + 1 to c, and the next one leaves c. Two
/// directions let one walk handle every winding: consistent, reversed, mixed, and surfaces with no
/// orientation at all.
using Flag = std::uint32_t;
inline constexpr Flag no_flag = 0xffffffffU;

inline Flag make_flag(Index triangle, int corner, unsigned direction = 0) {
    return (static_cast<Flag>(triangle) << 3U) | (static_cast<Flag>(corner) << 1U) | direction;
}
inline Index triangle_of(Flag f) { return static_cast<Index>(f >> 3U); }
inline std::size_t halfedge_of(Flag f) { return 3 * std::size_t(f >> 3U) + ((f >> 1U) & 3U); }
inline unsigned direction_of(Flag f) { return f & 1U; }
/// The same edge, gone along the other way.
inline Flag reversed(Flag f) { return f ^ 1U; }
/// The next edge around the triangle in the flag's direction.
inline Flag next(Flag f) {
    constexpr std::array<int, 8> step{2, 4, 2, -2, -4, -2, 0, 0};
    return f + static_cast<Flag>(step[f & 7U]);
}
inline Flag previous(Flag f) { return reversed(next(reversed(f))); }
/// next() of next() ..., `steps` (0 to 2) times: without a loop, whose end could not be predicted.
inline Flag next(Flag f, Flag steps) {
    constexpr std::array<std::uint8_t, 24> low{0, 1, 2, 3, 4, 5, 0, 0, 2, 5, 4, 1,
                                               0, 3, 0, 0, 4, 3, 0, 5, 2, 1, 0, 0};
    return (f & ~7U) | low[8 * steps + (f & 7U)];
}
inline Flag corner_of(Flag f) { return (f >> 1U) & 3U; }

/// Numbered along breadth-first traversals of its own, so that neighbours lie close in memory and every
/// island (piece connected through manifold edges) is a range of triangles. Edges with more than two
/// triangles are cut open; vertices that several islands share are linked vertices.
struct CombinatorialMap {
    std::vector<Flag> twin;     ///< of each half-edge 3 t + c, as direction-0 flag; no_flag at a border
    std::vector<Index> corner;  ///< vertex at each corner 3 t + c
    std::vector<Index> input_triangle;  ///< the mesh's number of each triangle
    std::vector<Index> input_vertex;    ///< the mesh's number of each vertex; isolated ones are not here
    std::vector<Index> island_begin;    ///< triangles of island i: island_begin[i] .. island_begin[i + 1]
    std::vector<std::uint8_t>
        flipped;  ///< 1 where a triangle is wound against its island's majority; empty: none
    std::vector<std::uint8_t> one_sided;  ///< 1 for islands without orientation (Moebius bands); empty: none
    std::vector<Index> isolated;          ///< the mesh's vertices without triangles
    Index nonmanifold_edges = 0;          ///< edges with more than two triangles
    Index boundary_edges = 0;             ///< edges with one triangle
    Index linked_vertices = 0;            ///< vertices in more than one island

    Index n_triangles() const { return static_cast<Index>(input_triangle.size()); }
    Index n_vertices() const { return static_cast<Index>(input_vertex.size()); }
    Index n_islands() const { return static_cast<Index>(island_begin.size()) - 1; }
    Index island_size(Index island) const {
        return island_begin[static_cast<std::size_t>(island) + 1] -
               island_begin[static_cast<std::size_t>(island)];
    }
    /// The flag on the other side of the edge, gone along so that the surface is crossed smoothly; no_flag at
    /// a border.
    Flag across(Flag f) const {
        const Flag t = twin[halfedge_of(f)];
        return t == no_flag ? no_flag : t ^ direction_of(f);
    }
    Index origin(Flag f) const {
        const std::size_t t = 3 * std::size_t(f >> 3U), c = ((f >> 1U) & 3U) + direction_of(f);
        return corner[t + (c == 3 ? 0 : c)];
    }
    /// The triangle's corner that is not on the edge.
    Index apex(Flag f) const {
        const std::size_t t = 3 * std::size_t(f >> 3U), c = ((f >> 1U) & 3U) + 2;
        return corner[t + (c >= 3 ? c - 3 : c)];
    }
    /// Corner of the mesh, 3 * input triangle + corner, that the flag's origin is.
    Index input_corner(Flag f) const {
        const Index c = static_cast<Index>((f >> 1U) & 3U) + static_cast<Index>(direction_of(f));
        return 3 * input_triangle[static_cast<std::size_t>(f >> 3U)] + (c == 3 ? 0 : c);
    }
    bool is_one_sided(Index island) const {
        return !one_sided.empty() && one_sided[static_cast<std::size_t>(island)] != 0;
    }
    /// 1 if the flag goes around its triangle against the majority of its island.
    unsigned parity(Flag f) const {
        return direction_of(f) ^ (flipped.empty() ? 0U : flipped[static_cast<std::size_t>(f >> 3U)]);
    }
};

/// O(V + F), sort-free but for the edges at one vertex. At most 2^28 triangles; throws InvalidInput beyond.
CombinatorialMap make_combinatorial_map(const TriangleMesh& mesh);

}  // namespace counterpart
