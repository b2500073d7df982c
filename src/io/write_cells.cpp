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

}  // namespace counterpart
