// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <vector>

namespace counterpart::io {

/// Takes the triangles away that are not kept, with what belongs to their corners; of a polygon all or none
/// are kept. Vertices stay, in the objects that they were in. O(V + F).
void keep_triangles(AttributedMesh& content, const std::vector<char>& kept);

}  // namespace counterpart::io
