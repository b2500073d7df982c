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

/// Reads a mesh with what its format holds beside the triangles: glTF everything (see io/gltf.hpp); OBJ
/// texture coordinates and normals by corner, colours of vertices, materials' names; PLY normals, colours and
/// texture coordinates of vertices (s t, u v, texture_u texture_v), these of corners too (texcoord); the
/// others the triangles alone. Vertices and triangles are those of read_mesh. Throws IoError.
AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file);

/// Writes what the format that the extension names can hold; the rest is left out, as are colours (OBJ, PLY)
/// and normals (PLY) that differ between corners of one vertex. The file appears whole or
/// not at all. Throws IoError.
void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file);

}  // namespace counterpart
