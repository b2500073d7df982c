// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

struct RetriangulateOptions {
    double kept_share = 0.7;  ///< of the vertices, 0.05 .. 1: the others are collapsed into a neighbor
    double flip_share = 0.5;  ///< of the triangles that then exchange a diagonal with a neighbor, 0 .. 1
    std::uint64_t seed = 1;   ///< of both choices
};

struct RetriangulateResult {
    TriangleMesh mesh;
    std::vector<Index> original_from_mesh;  ///< the true map: the vertices keep their places and order
};

/// Nearly the same surface in other triangles, so that connectivity says nothing of where a vertex came from:
/// random vertices are collapsed into a neighbor, then random edges flipped. No triangle turns over or gets
/// much thinner than those that it replaces, the topology stays, boundary and non-manifold vertices stay. So
/// fewer vertices may go, and fewer edges be flipped, than asked for. Polygons are not kept. O(V log V).
/// Throws InvalidInput for an invalid mesh or options out of range.
RetriangulateResult retriangulate(MeshView mesh, const RetriangulateOptions& options = {});

}  // namespace counterpart
