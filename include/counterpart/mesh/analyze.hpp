// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>
#include <vector>

namespace counterpart {

/// One connected component of a mesh (triangles connected through shared vertices).
struct ComponentReport {
    Index n_vertices = 0;
    Index n_edges = 0;
    Index n_triangles = 0;  ///< without degenerate ones
    Index n_boundary_loops = 0;
    bool is_manifold = true;    ///< every edge has one or two triangles, every vertex one fan of them
    bool is_orientable = true;  ///< the triangles can be oriented consistently
    Index euler_characteristic() const { return n_vertices - n_edges + n_triangles; }
    /// Handles: (2 - boundary loops - Euler characteristic) / 2; only for orientable manifolds.
    std::optional<Index> genus() const;
};

/// Statistics and defects of a mesh. A triangle with a repeated vertex is degenerate and does not count for
/// edges, boundaries or components.
struct MeshReport {
    Index n_vertices = 0;
    Index n_edges = 0;
    Index n_triangles = 0;
    Index n_isolated_vertices = 0;     ///< in no triangle, or only in degenerate ones
    Index n_duplicate_vertices = 0;    ///< at exactly the position of an earlier vertex
    Index n_degenerate_triangles = 0;  ///< with a repeated vertex
    Index n_zero_area_triangles = 0;   ///< not degenerate, but of area 0
    Index n_duplicate_triangles = 0;   ///< with the vertices of an earlier triangle, in any order
    Index n_boundary_edges = 0;        ///< with one triangle
    Index n_nonmanifold_edges = 0;     ///< with three or more triangles
    Index n_nonmanifold_vertices = 0;  ///< whose triangles do not form a single fan
    Index n_boundary_loops = 0;
    bool is_consistently_oriented = true;     ///< no two triangles traverse an edge in the same direction
    std::vector<ComponentReport> components;  ///< without isolated vertices; by smallest vertex

    double area = 0;              ///< squared mesh units
    double mean_edge_length = 0;  ///< mesh units
    Eigen::RowVector3d box_min = Eigen::RowVector3d::Zero(), box_max = Eigen::RowVector3d::Zero();

    bool is_closed() const { return n_boundary_edges == 0; }
    bool is_manifold() const { return n_nonmanifold_edges == 0 && n_nonmanifold_vertices == 0; }
};

/// Counts and measures. O((V + F) log F). Throws InvalidInput for a mesh that require_valid rejects.
MeshReport analyze(MeshView mesh);

}  // namespace counterpart
