// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

/// M x 4 vertex indices, row-major.
using Tetrahedra = Eigen::Matrix<Index, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// A solid as tetrahedra. Vertex and tetrahedron numbers count from 0.
struct TetrahedralMesh {
    Points vertices;        ///< n_vertices x 3, in the mesh's units
    Tetrahedra tetrahedra;  ///< the first three corners are counter-clockwise seen from the fourth: det(b -
                            ///< a, c - a, d - a) > 0

    Index n_vertices() const { return static_cast<Index>(vertices.rows()); }
    Index n_tetrahedra() const { return static_cast<Index>(tetrahedra.rows()); }
};

/// Throws InvalidInput naming the first bad element: no tetrahedra or more than 2^27, a coordinate that is
/// not finite, a vertex number out of range or twice in one tetrahedron, a tetrahedron that is inverted or
/// has no volume. O(V + T).
void require_valid(const TetrahedralMesh& mesh);

/// Volume of each tetrahedron, negative for one that is inverted.
Vector tetrahedron_volumes(const TetrahedralMesh& mesh);

/// All faces of the tetrahedra, each once, over the same vertices: two vertices share an edge here if they do
/// in the solid, so that distances run through the inside. O(T).
TriangleMesh all_faces(const TetrahedralMesh& mesh);

/// The surface of a solid: the faces with one tetrahedron, counter-clockwise seen from outside.
struct SolidBoundary {
    TriangleMesh mesh;            ///< without the vertices inside
    std::vector<Index> vertices;  ///< of the solid, of each vertex of the mesh, increasing
};
/// O(T).
SolidBoundary boundary(const TetrahedralMesh& mesh);

/// Fills a closed surface with cubes, `cells` (1 .. 256) along its longest side, and cuts each into six
/// tetrahedra (Kuhn). A cube is there if its middle is inside: an odd number of triangles lie on one side of
/// it. For tests and examples: the boundary has steps. Throws InvalidInput for an invalid mesh, one that
/// holds no cube's middle, and `cells` out of range. O(cells^3 + F cells).
TetrahedralMesh fill_with_tetrahedra(MeshView surface, int cells);

struct TetrahedralShuffleResult {
    TetrahedralMesh mesh;
    std::vector<Index> shuffled_from_original;  ///< the true map: new index of each old vertex
};
/// The same solid with its vertices, tetrahedra and their corners in random order; no tetrahedron is
/// inverted.
TetrahedralShuffleResult shuffle(const TetrahedralMesh& mesh, std::uint64_t seed);

}  // namespace counterpart
