// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

struct WeldOptions {
    double distance =
        0;  ///< mesh units, at least 0; vertices this close become one. 0 = the same position exactly
};

struct WeldResult {
    TriangleMesh mesh;                        ///< each kept vertex where it was, in the old order
    std::vector<Index> welded_from_original;  ///< new number of each old vertex
};

/// Joins vertices by position: each vertex, in order, becomes one with the first kept vertex within the
/// distance, or is kept itself. So a kept vertex does not move, kept vertices are farther apart than the
/// distance, and chains of close vertices do not collapse to a point. Triangles are kept, also those that
/// lose a corner by it. O(V) for distances below the edge lengths. Throws InvalidInput for an invalid mesh or
/// a distance that is negative or not finite.
WeldResult weld(const TriangleMesh& mesh, const WeldOptions& options = {});

}  // namespace counterpart
