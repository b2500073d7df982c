// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// The quality of a map as far as it can be measured without ground truth.
struct MapQuality {
    Index n_matched = 0;   ///< source vertices with an image
    Index n_distinct = 0;  ///< distinct target vertices among the images
    double coverage = 0;   ///< n_distinct / target vertices
    /// Of the source's edges with both ends matched, the fraction whose ends map to the two ends of a target
    /// edge, and the fraction whose ends map to one vertex; 0 if there are none. Between meshes of the same
    /// connectivity the former is 1 for the true map and decreases with the number of wrong vertices.
    double preserved_edges = 0, collapsed_edges = 0;
};

/// O(V + F). Throws InvalidInput for an invalid mesh or a map that does not fit the meshes.
MapQuality map_quality(const VertexMap& target_from_source, MeshView source, MeshView target);

}  // namespace counterpart
