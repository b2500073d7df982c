// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The connectivity of a triangle mesh: what is left of it when positions and numbering are forgotten.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace counterpart::isomorphism {

/// An integer as a container index.
template <class Integer>
constexpr std::size_t to_size(Integer i) {
    return static_cast<std::size_t>(i);
}

/// An oriented half-edge of triangle t, from corner c to corner c + 1, with the direction d in which its
/// triangle is traversed: 8 t + 2 c + d. With d = 1 it runs from corner c + 1 to c, and the next one leaves
/// c. Two directions let one traversal handle every winding: consistent, reversed, mixed, and surfaces with
/// no orientation at all.
using Dart = std::uint32_t;
inline constexpr Dart no_dart = 0xffffffffU;

inline Dart make_dart(Index triangle, int corner, unsigned direction = 0) {
    return (static_cast<Dart>(triangle) << 3U) | (static_cast<Dart>(corner) << 1U) | direction;
}
inline Index triangle_of(Dart f) { return static_cast<Index>(f >> 3U); }
inline std::size_t halfedge_of(Dart f) { return 3 * std::size_t(f >> 3U) + ((f >> 1U) & 3U); }
inline unsigned direction_of(Dart f) { return f & 1U; }
/// The next edge around the triangle in the dart's direction.
inline Dart next(Dart f) {
    constexpr std::array<int, 8> step{2, 4, 2, -2, -4, -2, 0, 0};
    return f + static_cast<Dart>(step[f & 7U]);
}
/// next() of next() ..., `steps` (0 to 2) times: without a loop, whose end could not be predicted.
inline Dart next(Dart f, Dart steps) {
    constexpr std::array<std::uint8_t, 24> low{0, 1, 2, 3, 4, 5, 0, 0, 2, 5, 4, 1,
                                               0, 3, 0, 0, 4, 3, 0, 5, 2, 1, 0, 0};
    return (f & ~7U) | low[8 * steps + (f & 7U)];
}
inline Dart corner_of(Dart f) { return (f >> 1U) & 3U; }

/// No vertex is the middle of a polygon.
inline constexpr Index no_center = std::numeric_limits<Index>::max();

/// Numbered along breadth-first traversals of its own, so that neighbors lie close in memory and every
/// component (piece connected through manifold edges) is a range of triangles. Edges with more than two
/// triangles are cut open; vertices that several components share are non-manifold vertices.
struct DartMap {
    std::vector<Dart> twin;     ///< of each half-edge 3 t + c, as direction-0 dart; no_dart at a border
    std::vector<Index> corner;  ///< vertex at each corner 3 t + c
    std::vector<Index> input_triangle;  ///< the mesh's number of each triangle
    std::vector<Index> input_vertex;    ///< the mesh's number of each vertex; isolated ones are not here
    std::vector<Index>
        component_begin;  ///< triangles of component i: component_begin[i] .. component_begin[i + 1]
    std::vector<std::uint8_t>
        flipped;  ///< 1 where a triangle is wound against its component's majority; empty: none
    std::vector<std::uint8_t>
        one_sided;                    ///< 1 for components without orientation (Moebius bands); empty: none
    std::vector<Index> isolated;      ///< the mesh's vertices without triangles
    Index first_center = no_center;   ///< the mesh's vertices from here on are the middles of polygons
    Index non_manifold_edges = 0;     ///< edges with more than two triangles
    Index boundary_edges = 0;         ///< edges with one triangle
    Index non_manifold_vertices = 0;  ///< vertices in more than one component

    Index n_triangles() const { return static_cast<Index>(input_triangle.size()); }
    Index n_vertices() const { return static_cast<Index>(input_vertex.size()); }
    Index n_components() const { return static_cast<Index>(component_begin.size()) - 1; }
    Index component_size(Index component) const {
        return component_begin[to_size(component) + 1] - component_begin[to_size(component)];
    }
    /// The dart on the other side of the edge, directed so that the surface is crossed smoothly; no_dart at
    /// a border.
    Dart across(Dart f) const {
        const Dart t = twin[halfedge_of(f)];
        return t == no_dart ? no_dart : t ^ direction_of(f);
    }
    Index origin(Dart f) const {
        const std::size_t t = 3 * std::size_t(f >> 3U), c = ((f >> 1U) & 3U) + direction_of(f);
        return corner[t + (c == 3 ? 0 : c)];
    }
    /// The triangle's corner that is not on the edge.
    Index apex(Dart f) const {
        const std::size_t t = 3 * std::size_t(f >> 3U), c = ((f >> 1U) & 3U) + 2;
        return corner[t + (c >= 3 ? c - 3 : c)];
    }
    /// Corner of the mesh, 3 * input triangle + corner, that the dart's origin is.
    Index input_corner(Dart f) const {
        const Index c = static_cast<Index>((f >> 1U) & 3U) + static_cast<Index>(direction_of(f));
        return 3 * input_triangle[to_size(f >> 3U)] + (c == 3 ? 0 : c);
    }
    bool is_one_sided(Index component) const {
        return !one_sided.empty() && one_sided[to_size(component)] != 0;
    }
    /// 1 if the dart goes around its triangle against the majority of its component.
    unsigned parity(Dart f) const {
        return direction_of(f) ^ (flipped.empty() ? 0U : flipped[to_size(f >> 3U)]);
    }
};

/// O(V + F), sort-free but for the edges at one vertex. At most 2^28 triangles; throws InvalidInput beyond.
/// `first_center`: of a mesh that mesh::coned made, the number of its first middle. An edge to a middle joins
/// two triangles, also where the polygon comes to one vertex several times.
DartMap make_dart_map(MeshView mesh, Index first_center = no_center);

}  // namespace counterpart::isomorphism
