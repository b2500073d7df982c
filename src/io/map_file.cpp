// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/map_bytes.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>

namespace counterpart {

VertexMap read_vertex_map(const std::filesystem::path& file, IndexBase base, Index target_size) {
    return io::parse_vertex_map(read_whole_file(file), file, base, target_size);
}

void write_vertex_map(const VertexMap& map, const std::filesystem::path& file, IndexBase base) {
    write_file(io::vertex_map_bytes(map, file, base), file);
}

}  // namespace counterpart
