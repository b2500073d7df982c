// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <string_view>

namespace counterpart {

/// The bytes of the source OBJ file with the target's shape: its lines in their order - polygons, groups,
/// materials, comments - with the target's `v` lines in the place of its own. Lines of vertices, texture
/// coordinates and normals keep their text; each corner has the texture coordinate and the normal of the
/// target's corner named by `target_corner_from_source` (source triangles x 3, entries 3 * triangle +
/// corner). A target without texture coordinates leaves the source's. Polylines with texture coordinates are
/// dropped. Both texts must be files that read_attributed_mesh accepts, `source_triangles` what it makes of
/// the first. Throws InvalidInput if the map is not complete or does not fit.
std::string reorder_obj(std::string_view source_text, std::string_view target_text,
                        const VertexMap& target_from_source, TrianglesView source_triangles,
                        TrianglesView target_corner_from_source);

/// The same for a source that is no OBJ file: its polygons, or its triangles where it has none.
std::string reorder_obj(MeshView source, std::string_view target_text, const VertexMap& target_from_source,
                        TrianglesView target_corner_from_source);

}  // namespace counterpart
