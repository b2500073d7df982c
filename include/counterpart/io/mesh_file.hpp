// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart {

/// A mesh as read, with what the reader had to do to it.
struct MeshFile {
    TriangleMesh
        mesh;  ///< vertex order and count exactly as in the file (STL: welded by position; glTF: at seams)
    std::vector<std::string> notices;  ///< sentences for the user: polygons triangulated, STL welded, ...
};

/// Reads OFF, OBJ, PLY (text and binary), STL (text and binary) or glTF 2.0 (.glb, .gltf; see io/gltf.hpp),
/// chosen by the file's extension.
/// Throws IoError naming the file, the line (text formats) and the reason, also for meshes that require_valid
/// refuses.
MeshFile read_mesh(const std::filesystem::path& file);

/// Writes OFF, OBJ, PLY (binary little-endian), STL (binary) or glTF, chosen by the extension. Text formats
/// hold the shortest decimals that read back to the same doubles; PLY holds doubles; STL and glTF hold
/// floats. The file appears whole or not at all. Throws IoError.
void write_mesh(const TriangleMesh& mesh, const std::filesystem::path& file);

}  // namespace counterpart
