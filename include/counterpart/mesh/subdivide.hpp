// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Cuts every triangle into four at the middles of its edges; the surface stays as it is. The old vertices
/// keep their numbers, then follow the middles in the order of the edges (smaller vertex, larger vertex). Of
/// a triangle come the three at its corners, then the one in the middle; degenerate triangles are dropped.
/// O(F log valence). Throws InvalidInput for a mesh that require_valid refuses, or if the result would have
/// too many vertices for Index.
TriangleMesh subdivide(const TriangleMesh& mesh);

}  // namespace counterpart
