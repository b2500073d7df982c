// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The readers of counterpart/io/map_file.hpp, on the bytes of a whole file; `file` tells the format
// and leads messages.
#pragma once

#include <counterpart/io/map_file.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

namespace counterpart::io {

VertexMap parse_vertex_map(std::string_view bytes, const std::filesystem::path& file,
                           IndexBase base = IndexBase::zero, Index target_size = -1);
std::string vertex_map_bytes(const VertexMap& map, const std::filesystem::path& file,
                             IndexBase base = IndexBase::zero);
SurfaceMap parse_surface_map(std::string_view bytes, const std::filesystem::path& file);
std::string surface_map_bytes(const SurfaceMap& map, const std::filesystem::path& file);
std::variant<VertexMap, SurfaceMap> parse_map(std::string_view bytes, const std::filesystem::path& file);

}  // namespace counterpart::io
