// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>

#include <filesystem>

namespace counterpart {

/// What the numbers in a file count from.
enum class IndexBase { zero = 0, one = 1 };

/// Reads a map or truth file: text, one target vertex per source vertex, -1 = unmatched, '#' starts a
/// comment; or a NumPy `.npy` vector of int32 or int64. target_size is left at the largest image + 1. Throws
/// IoError naming file, line and reason.
VertexMap read_vertex_map(const std::filesystem::path& file, IndexBase base = IndexBase::zero);

/// Writes `.npy` (int32) if the name ends so, else text. The file appears whole or not at all. Throws
/// IoError.
void write_vertex_map(const VertexMap& map, const std::filesystem::path& file,
                      IndexBase base = IndexBase::zero);

}  // namespace counterpart
