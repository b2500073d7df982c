// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <optional>

namespace counterpart::io {

/// The attribute with one row for each vertex, 0 where no triangle uses the vertex; nothing if there is no
/// attribute, a corner has none or corners at a vertex differ. O(V + F).
std::optional<Matrix> one_row_per_vertex(const CornerAttribute& attribute, MeshView mesh);

/// Throws InvalidInput unless corners, skin, morph targets and parts fit the mesh's triangles and vertices.
void require_consistent(const AttributedMesh& content);

}  // namespace counterpart::io
