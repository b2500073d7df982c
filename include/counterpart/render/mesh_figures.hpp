// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/base_vertices.hpp>
#include <counterpart/render/scene.hpp>
#include <counterpart/render/view.hpp>

#include <span>
#include <utility>
#include <vector>

namespace counterpart {

/// Pale, so that shading and what is drawn on it can be seen.
inline Color plain_color() { return {0.86, 0.855, 0.84}; }

/// Moves the meshes next to each other from left to right, the middles of their boxes at one height.
void arrange_in_row(std::span<Placement> placements);

/// The mesh in one colour.
Surface plain_surface(const TriangleMesh& mesh, const Placement& placement,
                      const Color& color = plain_color());

struct FrontierFigureOptions {
    Index every = 5;    ///< draw frontier 0, every, 2 every, ...; at least 1
    bool dots = false;  ///< a dot for each vertex instead of a band along each frontier
};
/// The mesh with every n-th frontier in its own colour, dark blue at the source to yellow at the farthest,
/// and a red dot at the source. `level` is the frontier of each vertex, -1 for those in none (grey). Throws
/// InvalidInput if the sizes differ or `every` is less than 1.
void add_frontiers(Scene& scene, const TriangleMesh& mesh, const Placement& placement,
                   std::span<const Index> level, const FrontierFigureOptions& options = {});

/// A dot for each base vertex, and its patch in one of eight pale colours.
void add_base_vertices(Scene& scene, const TriangleMesh& mesh, const Placement& placement,
                       const BaseVertices& bases);

/// The part of the mesh within `radius` (mesh units) of `center`: its edges in grey, the shortcuts across
/// them in orange, and its vertices as dots with one colour per frontier. Throws InvalidInput if no triangle
/// lies within.
void add_shortcuts(Scene& scene, const TriangleMesh& mesh, const Placement& placement,
                   std::span<const Index> level, Index center, double radius);

/// Vertices within `radius` of `center` that an add_shortcuts figure shows, as a mesh of their own.
TriangleMesh patch_around(const TriangleMesh& mesh, Index center, double radius);

/// Two frontiers in space: the dots and edges of the first in blue, of the second in orange, and a thin grey
/// line for each pair (index in first, index in second). All in picture space.
struct FrontierPair {
    Points first, second;
    std::vector<std::pair<Index, Index>> first_edges, second_edges, pairs;
};
void add_frontier_pair(Scene& scene, const FrontierPair& frontiers, double dot_radius);

}  // namespace counterpart
