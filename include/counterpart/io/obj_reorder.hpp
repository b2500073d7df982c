// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <string_view>

namespace counterpart {

/// The bytes of a target OBJ file with its `v` lines in the source's order and the source's triangles. The
/// lines of vertices, texture coordinates and normals keep their text; each corner keeps the texture
/// coordinate and the normal of the target's corner named by `target_corner_from_source` (source triangles x
/// 3, entries 3 * triangle + corner). Groups, materials and comments are dropped. `text` must be a file that
/// read_mesh accepts. Throws InvalidInput if the map is not complete or does not fit.
std::string reorder_obj(std::string_view text, const VertexMap& target_from_source,
                        const Triangles& source_triangles, const Triangles& target_corner_from_source);

}  // namespace counterpart
