// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "io/ply_header.hpp"

#include <counterpart/io/mesh_file.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace counterpart::io {

/// What to read beside the triangles.
struct PlyWanted {
    bool of_vertices = true, of_corners = true;
};

struct PlyColumns {
    MeshFile file;
    std::vector<PlyProperty> properties;  ///< of vertices, lists and coordinates left out
    std::vector<double> of_vertices;      ///< row by row: a number for each of the properties
    std::vector<double> of_corners;       ///< two for each corner of each face: `texcoord`; NaN if not there
};

/// Whether a list of a face has more than the 255 entries that a byte counts.
bool has_large_faces(MeshView mesh);
inline const char* list_size_type(bool large) { return large ? "uint" : "uchar"; }
void append_list_size(std::string& bytes, std::size_t size, bool large);

/// Throws IoError.
PlyColumns read_ply_columns(std::string_view bytes, const PlyWanted& wanted, const std::string& name);

}  // namespace counterpart::io
