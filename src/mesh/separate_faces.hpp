// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::mesh {

/// Whether most vertices lie at the places of others because faces do not share them, as flat shading and STL
/// files have it. The connectivity of such a mesh says nothing; that of the welded mesh does. O(V).
bool has_separate_faces(MeshView mesh);

}  // namespace counterpart::mesh
