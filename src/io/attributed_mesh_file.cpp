// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/corner_rows.hpp"
#include "io/formats.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

AttributedMeshFile read_attributed_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    if (is_gltf(file)) {
        GltfFile gltf = read_gltf(file, options);
        return {std::move(gltf.content), std::move(gltf.notices)};
    }
    const std::string extension = lower_extension(file);
    if (extension == ".obj" || extension == ".ply") {
        try {
            const auto read = extension == ".obj" ? read_attributed_obj : read_attributed_ply;
            AttributedMeshFile result = read(read_whole_file(file), file.string());
            require_valid(result.content.mesh);
            return result;
        } catch (const InvalidInput& error) {
            throw IoError(fmt::format("{}: {}", file.string(), error.what()));
        }
    }
    MeshFile plain = read_mesh(file);
    AttributedMeshFile result;
    result.content.mesh = std::move(plain.mesh);
    result.notices = std::move(plain.notices);
    return result;
}

void write_attributed_mesh(const AttributedMesh& content, const std::filesystem::path& file) {
    const std::string extension = mesh_extension(file);
    if (is_gltf(file)) return write_gltf(content, file);
    if (extension != ".obj" && extension != ".ply") return write_mesh(content.mesh, file);
    try {
        require_consistent(content);
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: not written: {}", file.string(), error.what()));
    }
    write_file(extension == ".obj" ? obj_bytes(content) : ply_bytes(content), file);
}

}  // namespace counterpart
