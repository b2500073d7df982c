// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// The target's shape in the source's order: vertex v has exactly the position of the image of source vertex
/// v, and the triangles are the source's. O(V + F). Throws InvalidInput if the map does not fit the meshes or
/// leaves a source vertex unmatched.
TriangleMesh reorder(MeshView source, MeshView target, const VertexMap& target_from_source);

/// The same with attributes. If the target has any, they are all the target's, including its document, in the
/// source's order; otherwise they are the source's, except normals. `target_corner_from_source`: source
/// triangles x 3, entries 3 * triangle + corner. O(V + F). Throws InvalidInput, also if the corners do not
/// fit.
AttributedMesh reorder(const AttributedMesh& source, const AttributedMesh& target,
                       const VertexMap& target_from_source, TrianglesView target_corner_from_source);

/// The mesh with every face wound the other way round, from the same first corner: a mirror image in the
/// order of its original (ExactResult::mirrored) is inside out until it is turned. Attributes stay at their
/// vertices, normals as they are. O(F).
AttributedMesh turned_inside_out(AttributedMesh content);

}  // namespace counterpart
