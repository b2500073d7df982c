// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

struct WeldOptions {
    /// Vertices up to this far apart are merged, mesh units, at least 0; 0 = only coincident ones.
    double distance = 0;
};

struct WeldResult {
    TriangleMesh mesh;                        ///< the kept vertices, unmoved and in the old order
    std::vector<Index> welded_from_original;  ///< new index of each old vertex
};

/// Merges vertices by position: each vertex, in order, is merged into the first kept vertex within the
/// distance, or is kept itself. So kept vertices do not move and are farther apart than the distance, and
/// chains of close vertices do not collapse to a point. All triangles are kept, including those that become
/// degenerate. O(V) for distances below the edge lengths. Throws InvalidInput for an invalid mesh or a
/// distance that is negative or not finite.
WeldResult weld(MeshView mesh, const WeldOptions& options = {});

}  // namespace counterpart
