// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <filesystem>
#include <variant>

namespace counterpart {

/// The index of the first vertex in a file.
enum class IndexBase { zero = 0, one = 1 };

/// Reads a map or truth file: text, one target vertex per source vertex, -1 = unmatched, '#' starts a
/// comment; or a NumPy `.npy` vector of int32 or int64. Files do not hold the number of target vertices: -1
/// takes the largest image + 1. Throws IoError naming file, line and reason.
VertexMap read_vertex_map(const std::filesystem::path& file, IndexBase base = IndexBase::zero,
                          Index target_size = -1);

/// Writes `.npy` (int32) if the file has that extension, else text. The file appears whole or not at all.
/// Throws IoError.
void write_vertex_map(const VertexMap& map, const std::filesystem::path& file,
                      IndexBase base = IndexBase::zero);

/// Reads a sub-vertex map: text with one line "triangle weight weight weight" per source vertex (triangles
/// from 0, -1 = unmatched, '#' starts a comment), or a NumPy `.npy` array of four columns. target_triangles
/// is left at the largest triangle + 1. Throws IoError naming file, line and reason.
SurfaceMap read_surface_map(const std::filesystem::path& file);

/// Writes `.npy` (float64, n x 4) if the file has that extension, else text with the shortest decimals that
/// read back to the same weights. The file appears whole or not at all. Throws IoError.
void write_surface_map(const SurfaceMap& map, const std::filesystem::path& file);

/// Reads either kind of map: a file with one number per line is a vertex map.
std::variant<VertexMap, SurfaceMap> read_map(const std::filesystem::path& file);

}  // namespace counterpart
