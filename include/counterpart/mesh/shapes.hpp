// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Unit sphere: an icosahedron subdivided 4-to-1 `subdivisions` times (0 .. 10); 10 * 4^subdivisions + 2
/// vertices.
TriangleMesh make_icosphere(int subdivisions);

/// Torus around the z axis with major radius 1 and minor radius 0.4; rings * segments vertices, both at
/// least 3.
TriangleMesh make_torus(int rings, int segments);

/// Unit square in the xy plane with columns x rows cells, each split along the same diagonal; both at
/// least 1.
TriangleMesh make_grid(int columns, int rows);

struct BodyOptions {
    int subdivisions = 2;    ///< 0 .. 7; each quadruples the vertices: about 4500 for 2
    bool symmetric = false;  ///< equal arms: one mirror symmetry (x -> -x), also of the connectivity
};

/// A figure with head, arms, legs and a tail, closed, of genus 0, about 1 high (y), facing +z. Unless
/// `symmetric`, its connectivity has no symmetry, so a copy of it can be matched in only one way.
TriangleMesh make_body(const BodyOptions& options = {});

/// Splits every triangle into four at the midpoints of its edges; the surface does not change. Old vertices
/// keep their indices, followed by the midpoints in the order of the edges (smaller vertex, larger vertex).
/// Each triangle is replaced by the three at its corners, then the middle one; degenerate triangles are
/// dropped. O(F log valence). Throws InvalidInput for a mesh that require_valid rejects, or if the result
/// would have too many vertices for Index.
TriangleMesh subdivide(MeshView mesh);

}  // namespace counterpart
