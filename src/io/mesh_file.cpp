// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/cells.hpp"
#include "io/formats.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/io/mesh_file.hpp>

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

struct Format {
    std::string_view extension;
    MeshFile (*read)(std::string_view bytes, const std::string& name);
    std::string (*bytes)(MeshView mesh);
};

constexpr std::array<Format, 4> formats = {{{".off", read_off, off_bytes},
                                            {".obj", read_obj, obj_bytes},
                                            {".ply", read_ply, ply_bytes},
                                            {".stl", read_stl, stl_bytes}}};

const Format& format_of(const std::filesystem::path& file) {
    const std::string extension = mesh_extension(file);
    const auto* found = std::find_if(formats.begin(), formats.end(),
                                     [&](const Format& format) { return format.extension == extension; });
    if (found == formats.end()) {
        throw IoError(fmt::format(
            "{}: the name must end in .off, .obj, .ply, .stl, .glb or .gltf, which tells the format",
            file.string()));
    }
    return *found;
}

}  // namespace

std::string io::mesh_extension(const std::filesystem::path& file) {
    const std::string extension = lower_extension(file);
    return extension.empty() && file == "/dev/stdout" ? ".obj" : extension;
}

MeshFile read_mesh(const std::filesystem::path& file, const ReadOptions& options) {
    if (is_gltf(file)) {
        GltfFile gltf = read_gltf(file, options);
        return {std::move(gltf.content.mesh), std::move(gltf.notices)};
    }
    try {
        MeshFile result = holds_cells(file) ? mesh_of_cells(read_cells(file), file.string())
                                            : format_of(file).read(read_whole_file(file), file.string());
        require_valid(result.mesh);
        return result;
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

void write_mesh(MeshView mesh, const std::filesystem::path& file) {
    if (is_gltf(file)) {
        AttributedMesh content;
        content.mesh = mesh.copy();
        write_gltf(content, file);
        return;
    }
    const Format& format = format_of(file);
    try {
        require_valid(mesh);
        if (format.extension == ".stl" &&
            mesh.vertices.cwiseAbs().maxCoeff() > static_cast<double>(std::numeric_limits<float>::max()))
            throw InvalidInput("a coordinate is too large for the floats of STL");
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: not written: {}", file.string(), error.what()));
    }
    write_file(format.bytes(mesh), file);
}

}  // namespace counterpart
