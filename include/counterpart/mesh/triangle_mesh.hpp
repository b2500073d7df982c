// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <span>
#include <vector>

namespace counterpart {

/// The most triangles that a mesh may have: what is counted for each of their corners and edges stays within
/// Index. require_valid refuses more.
inline constexpr Index max_triangles = Index{1} << 28;

/// The faces of a mesh some of which have more than three corners, each cut into triangles that follow one
/// another: n corners make n - 2 triangles. Numbers count from 0.
struct Polygons {
    std::vector<Index> first;  ///< polygon p has the corners first[p] .. first[p + 1]; empty: no polygons
    Triangles corners;         ///< n_triangles x 3: the polygon's corner at each corner of a triangle

    bool empty() const { return first.empty(); }
    Index count() const { return first.empty() ? 0 : static_cast<Index>(first.size()) - 1; }
    Index n_corners() const { return first.empty() ? 0 : first.back(); }
    Index size(Index p) const {
        return first[static_cast<std::size_t>(p) + 1] - first[static_cast<std::size_t>(p)];
    }
    /// Of polygon p, which has size(p) - 2 of them.
    Index first_triangle(Index p) const { return first[static_cast<std::size_t>(p)] - 2 * p; }
    /// For each corner of the polygons one of a triangle that stands for it, 3 * triangle + corner. O(F).
    std::vector<Index> triangle_corners() const;
};

/// A triangle mesh as plain data. Any set of triangles is allowed: boundaries, several components, isolated
/// vertices, non-manifold edges. Vertex and triangle numbers count from 0.
struct TriangleMesh {
    Points vertices;      ///< n_vertices x 3, in the mesh's units
    Triangles triangles;  ///< n_triangles x 3, counter-clockwise seen from outside
    Polygons polygons{};  ///< what the triangles were cut from; empty if nothing was cut
    /// Vertices whose place is not known, in increasing order: those that a file gives no numbers for. They
    /// lie where the others do on average, no triangle names them, and match() finds no partner for them.
    std::vector<Index> left_out{};

    Index n_vertices() const { return static_cast<Index>(vertices.rows()); }
    Index n_triangles() const { return static_cast<Index>(triangles.rows()); }
};

/// A mesh in arrays that someone else owns: of a `TriangleMesh`, or of memory that is laid out like it. It
/// must not outlive them. Functions take meshes as views by value, so that no caller has to copy.
struct MeshView {
    PointsView vertices;
    TrianglesView triangles;
    const Polygons* polygons = nullptr;  ///< null if there are none
    std::span<const Index> left_out;     ///< see TriangleMesh

    MeshView() = default;
    MeshView(const TriangleMesh& mesh)
        : MeshView(mesh.vertices, mesh.triangles, mesh.polygons.empty() ? nullptr : &mesh.polygons) {
        left_out = mesh.left_out;
    }
    MeshView(PointsView vertex_rows, TrianglesView triangle_rows, const Polygons* faces = nullptr)
        : vertices(vertex_rows), triangles(triangle_rows), polygons(faces) {}

    Index n_vertices() const { return static_cast<Index>(vertices.rows()); }
    Index n_triangles() const { return static_cast<Index>(triangles.rows()); }
    /// Vertices and triangles, without the polygons: whoever copies may mean to change the triangles.
    TriangleMesh copy() const { return {vertices, triangles}; }
};

/// A mesh of polygons, cut into triangles: `sizes` are their numbers of corners (at least 3), `corners` their
/// vertices one polygon after another. A polygon that is convex along its normal becomes a fan around its
/// first corner, another one is cut ear by ear (of more than max_ear_corners corners: a fan too). Bridges to
/// holes, repeated vertices, edges of length 0 are allowed. If all are triangles, `polygons` is empty.
/// O(n) for convex polygons, O(n^2) for others. Throws InvalidInput where sizes and corners do not fit.
TriangleMesh cut_into_triangles(PointsView vertices, std::span<const Index> sizes,
                                std::span<const Index> corners);

/// The largest polygon that is cut ear by ear, which takes the square of its corners.
inline constexpr Index max_ear_corners = 4096;

/// Throws InvalidInput naming the first bad element: no vertices, no triangles, a coordinate that is not
/// finite, a vertex number out of range, polygons that do not fit the triangles. Every public function that
/// takes a mesh expects it to pass. O(V + F).
void require_valid(MeshView mesh);

}  // namespace counterpart
