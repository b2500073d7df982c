// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/isomorphism/dart_map.hpp"

#include <span>
#include <vector>

namespace counterpart::diagonals {

/// Whether an edge may cut a quad in two. Unlikely: the quad would be bent far or not be convex.
enum class Cut : unsigned char { none, unlikely, likely };

/// Quads that are looked for where no polygons are known.
enum class Quads { convex, any };

/// One of two meshes whose quads may be cut along different diagonals.
struct Side {
    explicit Side(MeshView mesh_of_side);

    MeshView mesh;
    isomorphism::DartMap map;
    std::vector<Cut> may_cut;                ///< of each half-edge of the map. Empty: none is known to
    double scale = 1;                        ///< mean length of an edge
    std::vector<isomorphism::Dart> corners;  ///< by vertex
    std::vector<std::size_t> corner_begin;   ///< where those of each vertex begin; one more at the end

    Eigen::RowVector3d at(Index v) const {
        return mesh.vertices.row(map.input_vertex[static_cast<std::size_t>(v)]);
    }
    /// Of length 1, or 0 where the triangle has no area.
    Eigen::RowVector3d normal(Index t) const;
    bool is_manifold() const { return map.non_manifold_edges == 0 && map.non_manifold_vertices == 0; }
    /// The darts of direction 0 that leave it.
    std::span<const isomorphism::Dart> corners_at(Index v) const {
        const auto first = corner_begin[static_cast<std::size_t>(v)];
        return std::span(corners).subspan(first, corner_begin[static_cast<std::size_t>(v) + 1] - first);
    }
    /// Fills may_cut: edges inside polygons of a mesh that has some, of another one `by_shape` if asked to.
    void find_diagonals(bool by_shape, Quads quads);

  private:
    bool is_inside_polygon(isomorphism::Dart f, const std::vector<Index>& polygon) const;
    bool cuts_convex_quad(isomorphism::Dart f) const;
};

}  // namespace counterpart::diagonals
