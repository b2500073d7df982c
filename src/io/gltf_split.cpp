// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/gltf_split.hpp"

#include <algorithm>
#include <map>

namespace counterpart::io {
namespace {

// What the vertices of the content say, at the given ones.
void gather_vertices(const std::vector<Index>& vertices, const AttributedMesh& content,
                     GltfPrimitive& primitive) {
    primitive.positions = content.mesh.vertices(vertices, Eigen::all);
    primitive.skin = {};
    if (content.skin.weights.cols() > 0) {
        primitive.skin.joints = content.skin.joints(vertices, Eigen::all);
        primitive.skin.weights = content.skin.weights(vertices, Eigen::all);
    }
    primitive.displacements.clear();
    for (const MorphTarget& morph : content.morphs)
        primitive.displacements.emplace_back(morph.displacements(vertices, Eigen::all));
}

// The values of one attribute at the primitive's vertices; those without a triangle keep `otherwise`. No rows
// if the triangles have none; nothing if two corners disagree.
std::optional<Matrix> at_vertices(const CornerAttribute& attribute, TrianglesView triangles,
                                  Index first_triangle, Eigen::Index n_vertices, const Matrix* otherwise) {
    if (attribute.values.rows() == 0) return Matrix();
    Matrix values = Matrix::Zero(n_vertices, attribute.values.cols());
    if (otherwise != nullptr && otherwise->rows() == n_vertices) {
        const Eigen::Index columns = std::min(values.cols(), otherwise->cols());
        values.leftCols(columns) = otherwise->leftCols(columns);
    }
    std::vector<Index> row_of(static_cast<std::size_t>(n_vertices), -2);
    bool any = false, all = true;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index vertex = triangles(t, c), row = attribute.corners(first_triangle + t, c);
            (row >= 0 ? any : all) = row >= 0;
            Index& known = row_of[static_cast<std::size_t>(vertex)];
            if (row < 0 || known == row) continue;
            if (known >= 0 && attribute.values.row(known) != attribute.values.row(row)) return {};
            known = row;
            values.row(vertex) = attribute.values.row(row);
        }
    }
    if (!any) return Matrix();
    return all ? std::optional(values) : std::nullopt;
}

const Matrix* set_or_null(const std::vector<Matrix>& sets, std::size_t i) {
    return i < sets.size() ? &sets[i] : nullptr;
}

// Sets are numbered without gaps.
void drop_absent_sets(std::vector<Matrix>& sets) {
    while (!sets.empty() && sets.back().rows() == 0) sets.pop_back();
}

// All that is said at one corner beside its vertex, and which attributes say nothing there.
std::vector<double> corner_key(const AttributedMesh& content, Index triangle, int corner) {
    std::vector<double> key;
    const auto add = [&](const CornerAttribute& attribute) {
        if (attribute.values.rows() == 0) return;
        const Index row = attribute.corners(triangle, corner);
        key.push_back(row >= 0 ? 1 : 0);
        for (Eigen::Index c = 0; c < attribute.values.cols(); ++c)
            key.push_back(row >= 0 ? attribute.values(row, c) + 0.0 : 0);
    };
    add(content.normals);
    for (const CornerAttribute& attribute : content.texture_coordinates) add(attribute);
    for (const CornerAttribute& attribute : content.colors) add(attribute);
    return key;
}

// The values of an attribute at given corners (3 * triangle + corner); 1 where it has none, as colors take.
Matrix at_corners(const CornerAttribute& attribute, const std::vector<std::int64_t>& corners) {
    if (attribute.values.rows() == 0) return {};
    Matrix values = Matrix::Ones(static_cast<Eigen::Index>(corners.size()), attribute.values.cols());
    bool any = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Index row = attribute.corners(static_cast<Eigen::Index>(corners[i] / 3), corners[i] % 3);
        if (row < 0) continue;
        any = true;
        values.row(static_cast<Eigen::Index>(i)) = attribute.values.row(row);
    }
    return any ? values : Matrix();
}

}  // namespace

std::optional<GltfPrimitive> in_same_vertices(const GltfPrimitive& primitive, const GltfOffsets& offsets,
                                              std::span<const Index> vertex_from_file,
                                              const AttributedMesh& content) {
    GltfPrimitive result;
    result.triangles = primitive.triangles;
    const auto own =
        vertex_from_file.subspan(offsets.vertex, static_cast<std::size_t>(primitive.positions.rows()));
    gather_vertices({own.begin(), own.end()}, content, result);
    const auto at = [&](const CornerAttribute& attribute, const Matrix* otherwise) {
        return at_vertices(attribute, primitive.triangles, offsets.triangle, primitive.positions.rows(),
                           otherwise);
    };
    const auto normals = at(content.normals, &primitive.normals);
    if (!normals) return {};
    result.normals = *normals;
    for (std::size_t i = 0; i < content.texture_coordinates.size(); ++i) {
        const auto values = at(content.texture_coordinates[i], set_or_null(primitive.texture_coordinates, i));
        if (!values) return {};
        result.texture_coordinates.push_back(*values);
    }
    for (std::size_t i = 0; i < content.colors.size(); ++i) {
        const auto values = at(content.colors[i], set_or_null(primitive.colors, i));
        if (!values) return {};
        result.colors.push_back(*values);
    }
    drop_absent_sets(result.texture_coordinates);
    drop_absent_sets(result.colors);
    return result;
}

GltfPrimitive in_new_vertices(std::span<const Index> triangles, const AttributedMesh& content) {
    using Key = std::pair<Index, std::vector<double>>;
    std::map<Key, std::int64_t> first_corner;
    for (const Index t : triangles)
        for (int c = 0; c < 3; ++c)
            first_corner.emplace(Key{content.mesh.triangles(t, c), corner_key(content, t, c)},
                                 3 * std::int64_t{t} + c);
    // In the order of the content's vertices, then of the triangles.
    std::vector<std::pair<Index, std::int64_t>> order;
    for (const auto& [key, corner] : first_corner) order.emplace_back(key.first, corner);
    std::sort(order.begin(), order.end());
    std::map<std::int64_t, Index> number;
    std::vector<Index> vertices;
    std::vector<std::int64_t> corners;
    for (const auto& [vertex, corner] : order) {
        number.emplace(corner, static_cast<Index>(number.size()));
        vertices.push_back(vertex);
        corners.push_back(corner);
    }
    GltfPrimitive result;
    result.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const Key key{content.mesh.triangles(triangles[i], c), corner_key(content, triangles[i], c)};
            result.triangles(static_cast<Eigen::Index>(i), c) = number.at(first_corner.at(key));
        }
    }
    gather_vertices(vertices, content, result);
    result.normals = at_corners(content.normals, corners);
    for (const CornerAttribute& attribute : content.texture_coordinates)
        result.texture_coordinates.push_back(at_corners(attribute, corners));
    for (const CornerAttribute& attribute : content.colors)
        result.colors.push_back(at_corners(attribute, corners));
    drop_absent_sets(result.texture_coordinates);
    drop_absent_sets(result.colors);
    return result;
}

}  // namespace counterpart::io
