// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart {

/// A mesh with its attributes as read, with what the reader had to do to it.
struct AttributedMeshFile {
    AttributedMesh content;
    std::vector<std::string> notices;  ///< sentences for the user
};

/// Reads a mesh with what its format holds beside the triangles: glTF everything (see io/gltf.hpp); the
/// others the triangles alone. Vertices and triangles are those of read_mesh. Throws IoError.
AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file);

/// Writes what the format that the extension names can hold; the rest is left out. The file appears whole or
/// not at all. Throws IoError.
void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file);

}  // namespace counterpart
