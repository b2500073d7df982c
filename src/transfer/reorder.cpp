// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

bool has_attributes(const AttributedMesh& content) {
    return content.normals.values.rows() > 0 || !content.texture_coordinates.empty() ||
           !content.colors.empty() || content.skin.weights.cols() > 0 || !content.morphs.empty() ||
           !content.values.empty();
}

void require_corners(TrianglesView corners, MeshView source, MeshView target) {
    const bool fits =
        corners.rows() == source.n_triangles() &&
        (corners.rows() == 0 || (corners.minCoeff() >= 0 && corners.maxCoeff() / 3 < target.n_triangles()));
    if (!fits) throw InvalidInput("the corner map does not fit the triangles of the meshes");
}

CornerAttribute in_order(CornerAttribute attribute, TrianglesView from) {
    if (attribute.values.rows() == 0) return attribute;
    const Triangles before = std::move(attribute.corners);
    attribute.corners.resize(from.rows(), 3);
    for (Eigen::Index t = 0; t < from.rows(); ++t)
        for (int c = 0; c < 3; ++c) attribute.corners(t, c) = before(from(t, c) / 3, from(t, c) % 3);
    return attribute;
}

}  // namespace

AttributedMesh reorder(const AttributedMesh& source, const AttributedMesh& target,
                       const VertexMap& target_from_source, TrianglesView target_corner_from_source) {
    TriangleMesh mesh = reorder(source.mesh, target.mesh, target_from_source);
    require_corners(target_corner_from_source, source.mesh, target.mesh);
    AttributedMesh result = has_attributes(target) ? target : source;
    result.mesh = std::move(mesh);
    result.objects = source.objects;
    if (!has_attributes(target)) {
        result.normals = {};
        return result;
    }
    TrianglesView from = target_corner_from_source;
    result.normals = in_order(std::move(result.normals), from);
    for (CornerAttribute& set : result.texture_coordinates) set = in_order(std::move(set), from);
    for (CornerAttribute& set : result.colors) set = in_order(std::move(set), from);
    std::vector<Index> vertices;
    for (Index v = 0; v < source.mesh.n_vertices(); ++v) vertices.push_back(target_from_source[v]);
    if (target.skin.weights.cols() > 0) {
        result.skin.joints = target.skin.joints(vertices, Eigen::all);
        result.skin.weights = target.skin.weights(vertices, Eigen::all);
    }
    for (std::size_t i = 0; i < target.morphs.size(); ++i)
        result.morphs[i].displacements = target.morphs[i].displacements(vertices, Eigen::all);
    for (std::size_t i = 0; i < target.values.size(); ++i)
        result.values[i].values = target.values[i].values(vertices, Eigen::all);
    if (!target.parts.empty()) {
        result.parts.clear();
        for (Eigen::Index t = 0; t < from.rows(); ++t)
            result.parts.push_back(target.parts[static_cast<std::size_t>(from(t, 0) / 3)]);
    }
    return result;
}

AttributedMesh turned_inside_out(AttributedMesh content) {
    const auto turn = [](Triangles& corners) {
        if (corners.rows() > 0) corners.col(1).swap(corners.col(2));
    };
    turn(content.mesh.triangles);
    turn(content.normals.corners);
    for (CornerAttribute& set : content.texture_coordinates) turn(set.corners);
    for (CornerAttribute& set : content.colors) turn(set.corners);
    Polygons& polygons = content.mesh.polygons;
    turn(polygons.corners);
    for (Index p = 0; p < polygons.count(); ++p) {
        const Index begin = polygons.first[static_cast<std::size_t>(p)], size = polygons.size(p);
        auto corners = polygons.corners.middleRows(polygons.first_triangle(p), size - 2);
        corners = corners.unaryExpr([&](Index c) { return begin + (size - (c - begin)) % size; }).eval();
    }
    return content;
}

TriangleMesh reorder(MeshView source, MeshView target, const VertexMap& target_from_source) {
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    TriangleMesh result{Points(source.n_vertices(), 3), source.triangles};
    if (source.polygons != nullptr) result.polygons = *source.polygons;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v] == VertexMap::unmatched) {
            throw InvalidInput(
                fmt::format("source vertex {} is unmatched: only a complete map can bring the target into "
                            "the source's order",
                            v));
        }
        result.vertices.row(v) = target.vertices.row(target_from_source[v]);
    }
    return result;
}

}  // namespace counterpart
