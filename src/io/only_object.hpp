// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

namespace counterpart::io {

/// One of several objects of the content, as if the file held no other: its triangles and vertices in their
/// order, and of attributes, polygons and parts what they use. The content has no document. O(V + F).
AttributedMesh only_object(AttributedMesh content, Index object);

}  // namespace counterpart::io
