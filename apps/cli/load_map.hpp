// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "console.hpp"

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>

namespace counterpart::cli {

/// Reads a map file of either kind as a sub-vertex map: a vertex map is projected between the vertices
/// unless the meshes have one connectivity, `extend` as in ProjectOptions. Without a file, vertex i goes to
/// vertex i. Throws IoError naming the file if the map does not fit the meshes.
SurfaceMap load_surface_map(const std::filesystem::path& file, const TriangleMesh& source,
                            const TriangleMesh& target, const CommonOptions& options, int extend = 0);

/// Reads a vertex map between these meshes. Throws IoError naming the file if it does not fit them.
VertexMap load_vertex_map(const std::filesystem::path& file, const TriangleMesh& source,
                          const TriangleMesh& target);

}  // namespace counterpart::cli
