// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/cells.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

void append_points(std::string& text, const TetrahedralMesh& mesh, const char* end) {
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        text +=
            fmt::format("{} {} {}{}\n", mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2), end);
}

}  // namespace

std::string io::gmsh_bytes(const TetrahedralMesh& mesh) {
    std::string text = fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", mesh.n_vertices());
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        text += fmt::format("{} {} {} {}\n", v + 1, mesh.vertices(v, 0), mesh.vertices(v, 1),
                            mesh.vertices(v, 2));
    text += fmt::format("$EndNodes\n$Elements\n{}\n", mesh.n_tetrahedra());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        text += fmt::format("{} 4 2 0 1", t + 1);
        for (int c = 0; c < 4; ++c) text += fmt::format(" {}", mesh.tetrahedra(t, c) + 1);
        text += '\n';
    }
    return text + "$EndElements\n";
}

std::string io::medit_bytes(const TetrahedralMesh& mesh) {
    std::string text = fmt::format("MeshVersionFormatted 2\nDimension 3\nVertices\n{}\n", mesh.n_vertices());
    append_points(text, mesh, " 0");
    text += fmt::format("Tetrahedra\n{}\n", mesh.n_tetrahedra());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        for (int c = 0; c < 4; ++c) text += fmt::format("{} ", mesh.tetrahedra(t, c) + 1);
        text += "0\n";
    }
    return text + "End\n";
}

std::string io::vtk_bytes(const TetrahedralMesh& mesh) {
    std::string text = fmt::format(
        "# vtk DataFile Version 3.0\ncounterpart\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
        mesh.n_vertices());
    append_points(text, mesh, "");
    text += fmt::format("CELLS {} {}\n", mesh.n_tetrahedra(), 5 * std::int64_t{mesh.n_tetrahedra()});
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        text += '4';
        for (int c = 0; c < 4; ++c) text += fmt::format(" {}", mesh.tetrahedra(t, c));
        text += '\n';
    }
    text += fmt::format("CELL_TYPES {}\n", mesh.n_tetrahedra());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) text += "10\n";
    return text;
}

void write_tetrahedral_mesh(const TetrahedralMesh& mesh, const std::filesystem::path& file) {
    try {
        require_valid(mesh);
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: not written: {}", file.string(), error.what()));
    }
    const std::string extension = lower_extension(file);
    if (extension != ".msh" && extension != ".mesh" && extension != ".vtk")
        throw IoError(fmt::format("{}: the name of a mesh of tetrahedra must end in .msh, .mesh or .vtk",
                                  file.string()));
    write_file(extension == ".msh"    ? gmsh_bytes(mesh)
               : extension == ".mesh" ? medit_bytes(mesh)
                                      : vtk_bytes(mesh),
               file);
}

}  // namespace counterpart
