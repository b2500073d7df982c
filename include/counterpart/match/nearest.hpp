// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct NearestOptions {
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};

struct NearestResult {
    VertexMap target_from_source;
};

/// The naive baseline of Sahillioglu and Yemez, section 5: the meshes' centres of mass (means of the
/// vertices) are moved onto each other, then every source vertex takes the closest target vertex; of equally
/// close ones, the smallest. O(V log V). Throws InvalidInput for invalid meshes.
NearestResult match_nearest(const TriangleMesh& source, const TriangleMesh& target,
                            const NearestOptions& options = {});

}  // namespace counterpart
