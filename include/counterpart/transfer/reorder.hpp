// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// The target's shape in the source's order: vertex v is where the partner of source vertex v is, bit for
/// bit, and the triangles are the source's. O(V + F). Throws InvalidInput if the map does not fit the meshes
/// or leaves a source vertex unmatched.
TriangleMesh reorder(const TriangleMesh& source, const TriangleMesh& target,
                     const VertexMap& target_from_source);

}  // namespace counterpart
