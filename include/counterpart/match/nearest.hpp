// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// How the meshes are aligned before the closest vertices are taken.
enum class NearestAlignment {
    centroids,   ///< the means of the vertices coincide
    similarity,  ///< the best similarity that icp_from_principal_axes finds
};

struct NearestOptions {
    NearestAlignment alignment = NearestAlignment::centroids;
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

struct NearestResult {
    VertexMap target_from_source;
};

/// The naive baseline of Sahillioglu and Yemez, section 5: aligns the meshes, by default their centroids (see
/// NearestAlignment), then maps every source vertex to the closest target vertex; of equally close ones, the
/// smallest. O(V log V). Throws InvalidInput for invalid meshes.
NearestResult match_nearest(MeshView source, MeshView target, const NearestOptions& options = {});

}  // namespace counterpart
