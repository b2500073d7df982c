// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/io/file.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace counterpart {

/// The mesh of a glTF file. Vertices that were split at seams, being equal in position, skin and morphs
/// within one glTF mesh, are merged again.
struct GltfFile {
    AttributedMesh content;
    std::vector<Index>
        vertex_from_file;              ///< for each file vertex, all primitives in order, its merged vertex
    std::vector<std::string> notices;  ///< sentences for the user
};

/// Reads glTF 2.0, text (.gltf, with its buffers beside it or inside) or binary (.glb): the triangles of all
/// meshes, once for each node of the scene that shows them, where it puts them (skinned ones as bound).
/// Triangle strips and fans are cut into triangles; points and lines are left out with a notice. Throws
/// IoError naming the file, the element and the reason, also for what is not supported: glTF 1.0, compressed
/// meshes (Draco, meshopt). Buffers and images come from the file itself or from its folder and below, unless
/// `options` allow others. The memory it takes is bounded by the size of the file.
GltfFile read_gltf(const std::filesystem::path& file, const ReadOptions& options = {});

/// Writes glTF 2.0: one .glb, or one .gltf with its data inside. What `content.document` holds comes along,
/// textures beside it included, and what did not change in it keeps its accessors byte for byte; the rest is
/// stored in new ones (floats). While the triangles are the document's, so are the vertices as they are split
/// at seams, where the corners allow it; else vertices are split where corners differ, in the order of the
/// content's. Vertices without triangles are then left out, as are tangents and other attributes that only
/// the document knows. Above 0, `frames_per_second` adds an animation that shows the mesh and then its morph
/// targets one after the other, in place of any that moves them. The file appears whole or not at all. Throws
/// IoError, also if the parts of `content` do not fit each other, or a texture file is missing; InvalidInput
/// for a negative number.
void write_gltf(const AttributedMesh& content, const std::filesystem::path& file,
                double frames_per_second = 0);

/// The document of which Document::to_bytes made the bytes. Throws InvalidInput for others. O(size).
std::shared_ptr<const Document> document_from_bytes(std::string_view bytes);

}  // namespace counterpart
