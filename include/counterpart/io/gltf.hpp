// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace counterpart {

/// The surface of a glTF file. Vertices that were split for seams, being equal in position, skin and morphs
/// within one mesh, are one vertex again.
struct GltfFile {
    AttributedMesh content;
    std::vector<Index> vertex_from_file;  ///< of each file vertex, all primitives in order, the welded number
    std::vector<std::string> notices;     ///< sentences for the user
};

/// Reads glTF 2.0, text (.gltf, with its buffers beside it or inside) or binary (.glb): the triangles of all
/// meshes, each where the first node of the scene that holds it puts it (skinned ones as they are bound).
/// Triangle strips and fans are cut into triangles; points and lines are left out with a notice. Throws
/// IoError naming the file, the element and the reason, also for what is not supported: glTF 1.0, compressed
/// meshes (Draco, meshopt).
GltfFile read_gltf(const std::filesystem::path& file);

}  // namespace counterpart
