// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// One reader and one writer per mesh format, between the bytes of a whole file and a mesh; format_table.cpp
// lists them with those of other files.
//
// They are our own because the readers of the libraries at hand (CGAL's polygon soups among them) give no
// line numbers, let bad indices pass, and take longer; text goes through std::from_chars, and files are read
// in one go. A reader is given the file's name for its messages, throws IoError, and leaves the checks of
// require_valid that need no line number to read_mesh.
#pragma once

#include <counterpart/io/file.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <string>
#include <string_view>

namespace counterpart::io {

MeshFile read_off(std::string_view bytes, const std::string& name);
MeshFile read_ply(std::string_view bytes, const std::string& name);

/// Those that know objects, without attributes. Of STL, `options` choose one of them, whose corners alone are
/// joined, and tell whether coordinates that are no finite numbers are refused or left out.
AttributedMeshFile read_obj(std::string_view bytes, const std::string& name);
AttributedMeshFile read_stl(std::string_view bytes, const std::string& name, const ReadOptions& options = {});

/// Those that know attributes.
AttributedMeshFile read_attributed_obj(std::string_view bytes, const std::string& name);
AttributedMeshFile read_attributed_ply(std::string_view bytes, const std::string& name);
std::string obj_bytes(const AttributedMesh& content);
std::string ply_bytes(const AttributedMesh& content);

std::string off_bytes(MeshView mesh);
std::string obj_bytes(MeshView mesh);
std::string ply_bytes(MeshView mesh);
/// Throws InvalidInput if a coordinate is too large for its floats.
std::string stl_bytes(MeshView mesh);

}  // namespace counterpart::io
