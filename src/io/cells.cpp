// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/cells.hpp"

#include "io/formats.hpp"
#include "io/left_out.hpp"
#include "io/mesh_collector.hpp"
#include "mesh/hanging_vertices.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <iterator>
#include <utility>

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
    if (least_size > 0 && static_cast<std::size_t>(count) > (text.remaining() + 1) / least_size)
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

namespace {

// The surface of solids whose corners may be counted either way round: with no volume, as they stand.
MeshFile surface_of_tetrahedra(const Cells& cells) {
    MeshFile result;
    TetrahedralMesh solid{
        PointsView(cells.coordinates.data(), static_cast<Eigen::Index>(cells.n_vertices()), 3),
        Eigen::Map<const Tetrahedra>(cells.tetrahedra.data(), std::ssize(cells.tetrahedra) / 4, 4)};
    result.mesh.left_out = place_left_out(solid.vertices);
    const Vector volumes = tetrahedron_volumes(solid);
    Index n_turned = 0;
    for (Index t = 0; t < solid.n_tetrahedra(); ++t) {
        if (!(volumes[t] < 0)) continue;
        std::swap(solid.tetrahedra(t, 2), solid.tetrahedra(t, 3));
        ++n_turned;
    }
    if (n_turned > 0)
        result.notices.push_back(
            fmt::format("{} of {} tetrahedra are wound the other way; they were turned round", n_turned,
                        solid.n_tetrahedra()));
    const SolidBoundary surface = boundary(solid);
    result.mesh.triangles = surface.mesh.triangles.unaryExpr(
        [&](Index v) { return surface.vertices[static_cast<std::size_t>(v)]; });
    result.mesh.vertices = std::move(solid.vertices);
    result.notices.push_back(fmt::format("the surface of {} tetrahedra", solid.n_tetrahedra()));
    return result;
}

MeshFile surface_of_faces(const Cells& cells) {
    Points points = PointsView(cells.coordinates.data(), static_cast<Eigen::Index>(cells.n_vertices()), 3);
    std::vector<Index> left_out = place_left_out(points);
    MeshFile result{cut_into_triangles(points, cells.face_sizes, cells.face_corners), {}};
    result.mesh.left_out = std::move(left_out);
    return result;
}

void require_row_each(const Matrix& values, std::int64_t n, const std::string& what,
                      const std::string& name) {
    if (values.rows() != 0 && values.rows() != n)
        throw IoError(fmt::format("{}: there are {} {} for {} points", name, values.rows(), what, n));
}

}  // namespace

AttributedMeshFile io::content_of_cells(const Cells& cells, const std::string& name) {
    MeshFile mesh = cells.tetrahedra.empty() ? surface_of_faces(cells) : surface_of_tetrahedra(cells);
    AttributedMeshFile result{{}, cells.notices};
    result.notices.insert(result.notices.end(), mesh.notices.begin(), mesh.notices.end());
    AttributedMesh& content = result.content;
    content.mesh = std::move(mesh.mesh);
    const PointData& points = cells.points;
    require_row_each(points.normals, cells.n_vertices(), "normals", name);
    require_row_each(points.texture_coordinates, cells.n_vertices(), "texture coordinates", name);
    require_row_each(points.colors, cells.n_vertices(), "colors", name);
    for (const VertexValues& column : points.values)
        require_row_each(column.values, cells.n_vertices(), fmt::format("values '{}'", column.name), name);
    if (points.normals.rows() > 0) content.normals = {points.normals, content.mesh.triangles};
    if (points.texture_coordinates.rows() > 0)
        content.texture_coordinates.push_back({points.texture_coordinates, content.mesh.triangles});
    if (points.colors.rows() > 0) content.colors.push_back({points.colors, content.mesh.triangles});
    content.values = points.values;
    return result;
}

}  // namespace counterpart
