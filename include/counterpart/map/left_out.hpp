// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// The map without the vertices that either mesh leaves out (TriangleMesh::left_out): those of the source,
/// and whatever goes to one of the target, are unmatched. match() gives such maps. O(V).
VertexMap without_left_out(const VertexMap& target_from_source, MeshView source, MeshView target);

}  // namespace counterpart
