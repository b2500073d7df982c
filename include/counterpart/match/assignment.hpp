// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct AssignmentOptions {
    /// Largest number of vertices accepted: time grows with its cube, memory with its square.
    Index max_vertices = 5000;
    Progress progress{};
};

struct AssignmentResult {
    VertexMap target_from_source;  ///< one-to-one; unmatched only if the source has more vertices
    double cost = 0;               ///< sum of squared distances of the pairs, squared mesh units
};

/// The optimal-assignment baseline: aligns the centroids (means of the vertices) of the meshes, then finds
/// the one-to-one map with the least sum of squared Euclidean distances. Best where the meshes nearly
/// coincide; for different poses it solves the wrong problem exactly. O(V^3) time in the worst case, 8
/// V_source V_target bytes. Throws InvalidInput for invalid meshes and for ones above max_vertices.
AssignmentResult match_assignment(MeshView source, MeshView target, const AssignmentOptions& options = {});

}  // namespace counterpart
