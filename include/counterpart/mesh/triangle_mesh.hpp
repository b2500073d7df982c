// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart {

/// The most triangles that a mesh may have: what is counted for each of their corners and edges stays within
/// Index. require_valid refuses more.
inline constexpr Index max_triangles = Index{1} << 28;

/// A triangle mesh as plain data. Any set of triangles is allowed: boundaries, several components, isolated
/// vertices, non-manifold edges. Vertex and triangle numbers count from 0.
struct TriangleMesh {
    Points vertices;      ///< n_vertices x 3, in the mesh's units
    Triangles triangles;  ///< n_triangles x 3, counter-clockwise seen from outside

    Index n_vertices() const { return static_cast<Index>(vertices.rows()); }
    Index n_triangles() const { return static_cast<Index>(triangles.rows()); }
};

/// A mesh in arrays that someone else owns: of a `TriangleMesh`, or of memory that is laid out like it. It
/// must not outlive them. Functions take meshes as views by value, so that no caller has to copy.
struct MeshView {
    PointsView vertices;
    TrianglesView triangles;

    MeshView() = default;
    MeshView(const TriangleMesh& mesh) : vertices(mesh.vertices), triangles(mesh.triangles) {}
    MeshView(PointsView vertex_rows, TrianglesView triangle_rows)
        : vertices(vertex_rows), triangles(triangle_rows) {}

    Index n_vertices() const { return static_cast<Index>(vertices.rows()); }
    Index n_triangles() const { return static_cast<Index>(triangles.rows()); }
    TriangleMesh copy() const { return {vertices, triangles}; }
};

/// Throws InvalidInput naming the first bad element: no vertices, no triangles, a coordinate that is not
/// finite, or a vertex number out of range. Every public function that takes a mesh expects it to pass. O(V +
/// F).
void require_valid(MeshView mesh);

}  // namespace counterpart
