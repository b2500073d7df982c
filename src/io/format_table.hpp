// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The mesh formats by the extension of a file's name. A new one is a reader and a writer of its own
// (formats.hpp, cells.hpp) and a row in format_table.cpp: reading, writing, messages and the program follow.
#pragma once

#include "io/cells.hpp"

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace counterpart::io {

/// What a format can do; null is what it cannot. Writers are given what is valid; all throw IoError, or
/// InvalidInput without the file's name.
struct MeshFormat {
    std::string_view extension;  ///< in lower case, with its dot
    /// The mesh and its objects, without attributes.
    AttributedMeshFile (*read)(const std::filesystem::path& file, const ReadOptions& options) = nullptr;
    /// Null where there are no attributes.
    AttributedMeshFile (*read_attributed)(const std::filesystem::path& file,
                                          const ReadOptions& options) = nullptr;
    Cells (*read_cells)(const std::filesystem::path& file) = nullptr;  ///< points, faces and tetrahedra
    void (*write)(MeshView mesh, const std::filesystem::path& file) = nullptr;
    /// Null where there are no attributes.
    void (*write_attributed)(const AttributedMesh& content, const std::filesystem::path& file) = nullptr;
    void (*write_solid)(const TetrahedralMesh& mesh, const std::filesystem::path& file) = nullptr;
    bool has_objects = false;  ///< then its readers choose the object of the options
};

std::span<const MeshFormat> mesh_formats();

/// That of the file's extension, which may be in upper case; standard output gets OBJ. Null: there is none.
const MeshFormat* find_mesh_format(const std::filesystem::path& file);

}  // namespace counterpart::io
