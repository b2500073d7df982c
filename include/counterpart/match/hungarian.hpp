// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct HungarianOptions {
    /// Refuse meshes with more vertices than this: time grows with the cube, memory with the square.
    Index max_vertices = 5000;
    Progress progress{};
};

struct HungarianResult {
    VertexMap target_from_source;  ///< one-to-one; unmatched only if the source has more vertices
    double cost = 0;               ///< sum of squared distances of the pairs, squared mesh units
};

/// The optimal-assignment baseline: the meshes' centres of mass (means of the vertices) are moved onto each
/// other, then the one-to-one map with the least sum of squared Euclidean distances is found. Best where the
/// meshes nearly coincide; on far poses it solves the wrong problem exactly. O(V^3) time in the worst case, 8
/// V_source V_target bytes. Throws InvalidInput for invalid meshes and for ones above max_vertices.
HungarianResult match_hungarian(const TriangleMesh& source, const TriangleMesh& target,
                                const HungarianOptions& options = {});

}  // namespace counterpart
