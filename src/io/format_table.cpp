// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/format_table.hpp"

#include "io/chosen_object.hpp"
#include "io/formats.hpp"
#include "platform/files.hpp"

#include <counterpart/io/gltf.hpp>

#include <algorithm>
#include <array>

namespace counterpart::io {
namespace {

using Path = std::filesystem::path;

// Of formats whose readers and writers know only the bytes of one file.
template <auto read>
auto from_bytes(const Path& file, const ReadOptions&) {
    return read(read_whole_file(file), platform::utf8_name(file));
}

template <auto read>
Cells cells_from_bytes(const Path& file) {
    return read(read_whole_file(file), platform::utf8_name(file));
}

template <typename Content, std::string (*bytes)(Content)>
void to_bytes(Content content, const Path& file) {
    write_file(bytes(content), file);
}

AttributedMeshFile with_attributes(MeshFile plain) {
    AttributedMeshFile result{{}, std::move(plain.notices)};
    result.content.mesh = std::move(plain.mesh);
    return result;
}

template <auto read>
AttributedMeshFile mesh_from_bytes(const Path& file, const ReadOptions& options) {
    return with_attributes(from_bytes<read>(file, options));
}

// Of formats that know objects: the whole file, or one of them.
template <auto read>
AttributedMeshFile object_from_bytes(const Path& file, const ReadOptions& options) {
    AttributedMeshFile result = from_bytes<read>(file, options);
    if (options.object) take_object(result, *options.object);
    return result;
}

AttributedMeshFile read_stl_mesh(const Path& file, const ReadOptions& options) {
    return read_stl(read_whole_file(file), platform::utf8_name(file), options);
}

// A mesh through a writer of content.
template <std::string (*bytes)(const AttributedMesh&)>
void mesh_to_bytes(MeshView mesh, const Path& file) {
    AttributedMesh content;
    content.mesh = mesh.copy();
    if (mesh.polygons != nullptr) content.mesh.polygons = *mesh.polygons;
    write_file(bytes(content), file);
}

AttributedMeshFile read_gltf_content(const Path& file, const ReadOptions& options) {
    GltfFile gltf = read_gltf(file, options);
    return {std::move(gltf.content), std::move(gltf.notices)};
}

void write_gltf_mesh(MeshView mesh, const Path& file) {
    AttributedMesh content;
    content.mesh = mesh.copy();
    write_gltf(content, file);
}

void write_gltf_content(const AttributedMesh& content, const Path& file) { write_gltf(content, file); }

constexpr auto table = std::to_array<MeshFormat>({
    {.extension = ".off", .read = mesh_from_bytes<read_off>, .write = to_bytes<MeshView, off_bytes>},
    {.extension = ".obj",
     .read = object_from_bytes<read_obj>,
     .read_attributed = object_from_bytes<read_attributed_obj>,
     .write = to_bytes<MeshView, obj_bytes>,
     .write_attributed = to_bytes<const AttributedMesh&, obj_bytes>,
     .has_objects = true},
    {.extension = ".ply",
     .read = mesh_from_bytes<read_ply>,
     .read_attributed = from_bytes<read_attributed_ply>,
     .write = to_bytes<MeshView, ply_bytes>,
     .write_attributed = to_bytes<const AttributedMesh&, ply_bytes>},
    {.extension = ".stl", .read = read_stl_mesh, .write = to_bytes<MeshView, stl_bytes>, .has_objects = true},
    {.extension = ".glb",
     .read = read_gltf_content,
     .write = write_gltf_mesh,
     .write_attributed = write_gltf_content,
     .has_objects = true},
    {.extension = ".gltf",
     .read = read_gltf_content,
     .write = write_gltf_mesh,
     .write_attributed = write_gltf_content,
     .has_objects = true},
    // Gmsh, Medit, legacy VTK
    {.extension = ".msh",
     .read_cells = cells_from_bytes<read_gmsh>,
     .write_solid = to_bytes<const TetrahedralMesh&, gmsh_bytes>},
    {.extension = ".mesh",
     .read_cells = cells_from_bytes<read_medit>,
     .write_solid = to_bytes<const TetrahedralMesh&, medit_bytes>},
    {.extension = ".vtk",
     .read_cells = cells_from_bytes<read_vtk>,
     .write = mesh_to_bytes<vtk_bytes>,
     .write_attributed = to_bytes<const AttributedMesh&, vtk_bytes>,
     .write_solid = to_bytes<const TetrahedralMesh&, vtk_bytes>},
    {.extension = ".vtp",
     .read_cells = cells_from_bytes<read_vtp>,
     .write = mesh_to_bytes<vtp_bytes>,
     .write_attributed = to_bytes<const AttributedMesh&, vtp_bytes>},
    {.extension = ".gii", .read_cells = cells_from_bytes<read_gifti>},
    // Triangle and TetGen: several files
    {.extension = ".ele", .read_cells = read_ele},
    {.extension = ".node", .read_cells = read_ele},
    {.extension = ".poly", .read_cells = read_ele},
});

}  // namespace

std::span<const MeshFormat> mesh_formats() { return table; }

const MeshFormat* find_mesh_format(const std::filesystem::path& file) {
    std::string extension = lower_extension(file);
    if (extension.empty() && file == "/dev/stdout") extension = ".obj";
    const auto* const found = std::find_if(table.begin(), table.end(),
                                           [&](const MeshFormat& row) { return row.extension == extension; });
    return found == table.end() ? nullptr : found;
}

}  // namespace counterpart::io
