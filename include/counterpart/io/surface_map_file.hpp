// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>

#include <filesystem>
#include <variant>

namespace counterpart {

/// Reads a sub-vertex map: text with one line "triangle weight weight weight" per source vertex (triangles
/// from 0, -1 = unmatched, '#' starts a comment), or a NumPy `.npy` array of four columns. target_triangles
/// is left at the largest triangle + 1. Throws IoError naming file, line and reason.
SurfaceMap read_surface_map(const std::filesystem::path& file);

/// Writes `.npy` (float64, n x 4) if the name ends so, else text with the shortest decimals that read back
/// to the same weights. The file appears whole or not at all. Throws IoError.
void write_surface_map(const SurfaceMap& map, const std::filesystem::path& file);

/// Reads whichever of the two kinds of maps the file holds: one number per line is a vertex map.
std::variant<VertexMap, SurfaceMap> read_map(const std::filesystem::path& file);

}  // namespace counterpart
