// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/corner_rows.hpp"

#include <counterpart/base/errors.hpp>

#include <string>

#include <fmt/format.h>

namespace counterpart::io {
namespace {

void require_corners(const CornerAttribute& attribute, Index n_triangles, const char* what, int fewest,
                     int most) {
    if (attribute.values.rows() == 0) return;
    if (attribute.values.cols() < fewest || attribute.values.cols() > most)
        throw InvalidInput(
            fmt::format("the {} have {} numbers each, not {}", what, attribute.values.cols(), most));
    if (attribute.corners.rows() != n_triangles)
        throw InvalidInput(fmt::format("the {} have corners for {} triangles where the mesh has {}", what,
                                       attribute.corners.rows(), n_triangles));
    if (attribute.corners.minCoeff() < -1 || attribute.corners.maxCoeff() >= attribute.values.rows())
        throw InvalidInput(fmt::format("a corner names a row of the {} that does not exist", what));
}

void require_rows(Eigen::Index rows, Index n_vertices, const std::string& what) {
    if (rows != n_vertices)
        throw InvalidInput(
            fmt::format("{} has {} rows where the mesh has {} vertices", what, rows, n_vertices));
}

void require_objects(const MeshObjects& objects, MeshView mesh) {
    if (objects.names.size() < 2) return;  // all is in the one
    if (std::ssize(objects.of_triangle) != mesh.n_triangles() ||
        (!objects.of_vertex.empty() && std::ssize(objects.of_vertex) != mesh.n_vertices()))
        throw InvalidInput(fmt::format("there are {} triangles and {} vertices in objects, of {} and {}",
                                       objects.of_triangle.size(), objects.of_vertex.size(),
                                       mesh.n_triangles(), mesh.n_vertices()));
    const auto require_number = [&](Index object, Index least) {
        if (object < least || object >= std::ssize(objects.names))
            throw InvalidInput(
                fmt::format("a triangle or vertex is in object {}, which does not exist", object));
    };
    for (const Index object : objects.of_triangle) require_number(object, 0);
    for (const Index object : objects.of_vertex) require_number(object, -1);
}

}  // namespace

void require_consistent(const AttributedMesh& content) {
    require_valid(content.mesh);
    const Index n = content.mesh.n_vertices(), n_triangles = content.mesh.n_triangles();
    require_corners(content.normals, n_triangles, "normals", 3, 3);
    for (const CornerAttribute& set : content.texture_coordinates)
        require_corners(set, n_triangles, "texture coordinates", 2, 2);
    for (const CornerAttribute& set : content.colors) require_corners(set, n_triangles, "colors", 3, 4);
    if (content.skin.weights.cols() > 0) {
        require_rows(content.skin.weights.rows(), n, "the skin");
        require_rows(content.skin.joints.rows(), n, "the skin");
        if (content.skin.joints.cols() != content.skin.weights.cols())
            throw InvalidInput("the skin has not as many joints as weights");
    }
    for (const MorphTarget& morph : content.morphs)
        require_rows(morph.displacements.rows(), n, fmt::format("the morph target '{}'", morph.name));
    for (const VertexValues& column : content.values)
        require_rows(column.values.rows(), n, fmt::format("the array of values '{}'", column.name));
    require_objects(content.objects, content.mesh);
    if (!content.parts.empty() && static_cast<Index>(content.parts.size()) != n_triangles)
        throw InvalidInput(
            fmt::format("there are {} part labels for {} triangles", content.parts.size(), n_triangles));
}

std::optional<Matrix> one_row_per_vertex(const CornerAttribute& attribute, MeshView mesh) {
    if (attribute.values.rows() == 0) return {};
    Matrix rows = Matrix::Zero(mesh.n_vertices(), attribute.values.cols());
    std::vector<Index> row_of(static_cast<std::size_t>(mesh.n_vertices()), -1);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index v = mesh.triangles(t, c), row = attribute.corners(t, c);
            if (row < 0) return {};
            Index& known = row_of[static_cast<std::size_t>(v)];
            if (known >= 0 && attribute.values.row(known) != attribute.values.row(row)) return {};
            known = row;
            rows.row(v) = attribute.values.row(row);
        }
    }
    return rows;
}

}  // namespace counterpart::io
