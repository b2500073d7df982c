// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::differences {

/// Marks the source vertices that are unmatched because the target ends there: those of connected groups of
/// unmatched vertices with a neighbor that is not on the source's boundary while its image is on the
/// target's. One mark for each vertex. O(V + F log F).
std::vector<char> beyond_target(const VertexMap& target_from_source, MeshView source, MeshView target);

}  // namespace counterpart::differences
