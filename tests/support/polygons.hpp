// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes of polygons.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::test {

struct PolygonList {
    std::vector<Eigen::RowVector3d> vertices;
    std::vector<Index> sizes, corners;

    void add(const std::vector<Index>& polygon);
    TriangleMesh cut() const;
};

/// The polygons of a mesh, or its triangles.
PolygonList polygons_of(MeshView mesh);

/// The triangles of a mesh of quads and triangles, each quad cut along a random one of its diagonals; without
/// the quads.
TriangleMesh cut_at_random(const TriangleMesh& quads, std::uint64_t seed);

/// Each triangle in three quads, around the vertex in its middle.
TriangleMesh make_quads(MeshView mesh);

/// Polygons in the plane z = 0, apart from each other: for each number of corners 3 .. max_corners a concave
/// one, and one around a hole, to which a bridge leads.
TriangleMesh make_polygon_soup(Index max_corners, std::uint64_t seed);

}  // namespace counterpart::test
