// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// What can be said of a map without knowing the truth.
struct MapQuality {
    Index n_matched = 0;   ///< source vertices with an image
    Index n_distinct = 0;  ///< different target vertices among the images
    double coverage = 0;   ///< n_distinct / target vertices
    /// Shares of the source's edges with both ends matched (0 if there are none): whose images share an edge
    /// of the target, and whose images are one vertex. Between meshes of the same connectivity the first is 1
    /// for the true map and follows the share of right vertices.
    double preserved_edges = 0, collapsed_edges = 0;
};

/// O(V + F). Throws InvalidInput for an invalid mesh or a map that does not fit the meshes.
MapQuality map_quality(const VertexMap& target_from_source, const TriangleMesh& source,
                       const TriangleMesh& target);

}  // namespace counterpart
