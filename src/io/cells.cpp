// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/cells.hpp"

#include "io/formats.hpp"
#include "io/mesh_collector.hpp"
#include "mesh/hanging_vertices.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <fmt/format.h>

namespace counterpart {

using namespace io;

namespace {

void require_no_hanging_vertex(const Cells& cells, const TetrahedralMesh& mesh, const std::string& name) {
    if (const auto hanging = mesh::find_hanging_vertex(mesh))
        throw IoError(fmt::format(
            "{}:{}: vertex {} hangs on tetrahedron {}: it lies within a face or an edge, but is no corner",
            name, cells.tetrahedron_lines[static_cast<std::size_t>(hanging->tetrahedron)], hanging->vertex,
            hanging->tetrahedron));
}

}  // namespace

// Those of a file whose tetrahedra are all inverted are turned round: it counts their corners the other way.
TetrahedralMeshFile io::solid_of_cells(const Cells& cells, const std::string& name) {
    TetrahedralMeshFile result;
    result.mesh.vertices =
        PointsView(cells.coordinates.data(), static_cast<Eigen::Index>(cells.n_vertices()), 3);
    result.mesh.tetrahedra = Eigen::Map<const Tetrahedra>(
        cells.tetrahedra.data(), static_cast<Eigen::Index>(cells.tetrahedra.size() / 4), 4);
    TetrahedralMesh& mesh = result.mesh;
    Vector volumes = tetrahedron_volumes(mesh);
    if ((volumes.array() < 0).all()) {
        mesh.tetrahedra.col(2).swap(mesh.tetrahedra.col(3));
        volumes = -volumes;
        result.notices.emplace_back("all tetrahedra are wound the other way; they were turned round");
    }
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t) {
        if (volumes[t] > 0) continue;
        throw IoError(fmt::format("{}:{}: tetrahedron {} {}", name,
                                  cells.tetrahedron_lines[static_cast<std::size_t>(t)], t,
                                  volumes[t] < 0 ? "is inverted, unlike others" : "has no volume"));
    }
    require_valid(mesh);
    require_no_hanging_vertex(cells, mesh, name);
    if (!cells.face_sizes.empty())
        result.notices.push_back(
            fmt::format("{} faces beside the tetrahedra are left out", cells.face_sizes.size()));
    return result;
}

std::int64_t io::read_count(TextCursor& text, std::string_view what, std::size_t least_size) {
    text.next_content();
    const std::int64_t count = text.integer(what);
    if (count < 0 || count > max_count) text.fail(fmt::format("the {} is out of range: {}", what, count));
    // No memory is set aside for what cannot be there.
    if (static_cast<std::size_t>(count) > (text.remaining() + 1) / least_size)
        text.fail(fmt::format("the {} is {}, more than the file has room for", what, count));
    return count;
}

void io::read_corners(TextCursor& text, std::int64_t n_vertices, std::int64_t base, int n,
                      std::vector<Index>& corners) {
    for (int c = 0; c < n; ++c) {
        const std::int64_t v = text.integer("vertex of an element");
        if (v < base || v >= base + n_vertices)
            text.fail(
                fmt::format("the element names vertex {}, but vertices run from {} to {}{}", v, base,
                            base + n_vertices - 1,
                            v == 0 || v == n_vertices ? ": is it counted from 0 and 1 in one file?" : ""));
        corners.push_back(static_cast<Index>(v - base));
    }
}

MeshFile io::mesh_of_cells(const Cells& cells, const std::string& name) {
    if (cells.tetrahedra.empty()) {
        MeshFile result{cut_into_triangles(PointsView(cells.coordinates.data(),
                                                      static_cast<Eigen::Index>(cells.n_vertices()), 3),
                                           cells.face_sizes, cells.face_corners),
                        {}};
        return result;
    }
    const TetrahedralMeshFile solid = solid_of_cells(cells, name);
    const SolidBoundary surface = boundary(solid.mesh);
    MeshFile result{{solid.mesh.vertices, surface.mesh.triangles}, solid.notices};
    for (Eigen::Index i = 0; i < result.mesh.triangles.size(); ++i)
        result.mesh.triangles.data()[i] =
            surface.vertices[static_cast<std::size_t>(surface.mesh.triangles.data()[i])];
    result.notices.push_back(fmt::format("the surface of {} tetrahedra", solid.mesh.n_tetrahedra()));
    return result;
}

}  // namespace counterpart
