// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/formats.hpp"

#include <counterpart/io/attributed_mesh_file.hpp>
#include <counterpart/io/gltf.hpp>

namespace counterpart {

AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file) {
    if (is_gltf(file)) {
        GltfFile gltf = read_gltf(file);
        return {std::move(gltf.content), std::move(gltf.notices)};
    }
    MeshFile plain = read_mesh(file);
    AttributedMeshFile result;
    result.content.mesh = std::move(plain.mesh);
    result.notices = std::move(plain.notices);
    return result;
}

void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file) {
    if (is_gltf(file))
        write_gltf(content, file);
    else
        write_mesh(content.mesh, file);
}

}  // namespace counterpart
