// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart::io {

/// Moves points whose coordinates are not all finite to about where the others are on average, each to a
/// place of its own, and returns their numbers; none are moved if all are so. O(n).
std::vector<Index> place_left_out(Points& points);

/// Takes the faces away that name a vertex of content.mesh.left_out, with what belongs to their corners.
/// Returns how many triangles. O(V + F).
Index remove_faces_of_left_out(AttributedMesh& content);

}  // namespace counterpart::io
