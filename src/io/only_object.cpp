// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/only_object.hpp"

#include "io/kept_triangles.hpp"
#include "io/left_out.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace counterpart::io {
namespace {

// Some of a list, in its order.
struct Subset {
    std::vector<Index> kept;    // their old numbers
    std::vector<Index> number;  // for each old one its new number; -1: it goes

    explicit Subset(const std::vector<char>& is_kept) : number(is_kept.size(), -1) {
        for (std::size_t i = 0; i < is_kept.size(); ++i) {
            if (is_kept[i] == 0) continue;
            number[i] = static_cast<Index>(kept.size());
            kept.push_back(static_cast<Index>(i));
        }
    }
    Index operator[](Index old) const { return number[static_cast<std::size_t>(old)]; }
};

// Those that its triangles name, and those in it that no triangle names.
Subset vertices_of(const AttributedMesh& content, Index object) {
    const MeshObjects& objects = content.objects;
    std::vector<char> is_named(static_cast<std::size_t>(content.mesh.n_vertices()), 0), is_kept = is_named;
    for (Eigen::Index i = 0; i < content.mesh.triangles.size(); ++i) {
        const auto v = static_cast<std::size_t>(content.mesh.triangles.data()[i]);
        is_named[v] = 1;
        if (objects.of_triangle[static_cast<std::size_t>(i / 3)] == object) is_kept[v] = 1;
    }
    for (std::size_t v = 0; v < objects.of_vertex.size(); ++v)
        if (is_named[v] == 0 && objects.of_vertex[v] == object) is_kept[v] = 1;
    return Subset(is_kept);
}

template <class Rows>
Rows rows_of(const Rows& all, const Subset& rows) {
    return all.rows() == 0 ? all : Rows(all(rows.kept, Eigen::all));
}

// Lays those that are left out where the others of the object are.
void keep_vertices(TriangleMesh& mesh, const Subset& vertices) {
    for (const Index v : mesh.left_out)
        mesh.vertices.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
    mesh.vertices = rows_of(mesh.vertices, vertices);
    mesh.left_out = place_left_out(mesh.vertices);
    mesh.triangles = mesh.triangles.unaryExpr([&](Index v) { return vertices[v]; }).eval();
}

void keep_used_rows(CornerAttribute& attribute) {
    std::vector<char> is_used(static_cast<std::size_t>(attribute.values.rows()), 0);
    for (Eigen::Index i = 0; i < attribute.corners.size(); ++i)
        if (const Index row = attribute.corners.data()[i]; row >= 0)
            is_used[static_cast<std::size_t>(row)] = 1;
    const Subset rows(is_used);
    if (rows.kept.empty()) {
        attribute = {};
        return;
    }
    attribute.values = rows_of(attribute.values, rows);
    attribute.corners =
        attribute.corners.unaryExpr([&](Index row) { return row < 0 ? row : rows[row]; }).eval();
}

void keep_used_rows(std::vector<CornerAttribute>& sets) {
    for (CornerAttribute& set : sets) keep_used_rows(set);
    while (!sets.empty() && sets.back().values.rows() == 0) sets.pop_back();
}

void keep_used_parts(AttributedMesh& content) {
    if (content.parts.empty()) return;
    std::vector<char> is_used(content.part_names.size(), 0);
    for (const Index part : content.parts) is_used[static_cast<std::size_t>(part)] = 1;
    const Subset parts(is_used);
    std::vector<std::string> names;
    for (const Index part : parts.kept)
        names.push_back(std::move(content.part_names[static_cast<std::size_t>(part)]));
    content.part_names = std::move(names);
    for (Index& part : content.parts) part = parts[part];
    if (content.part_names == std::vector<std::string>{""}) content.parts = {}, content.part_names = {};
}

}  // namespace

AttributedMesh only_object(AttributedMesh content, Index object) {
    const Subset vertices = vertices_of(content, object);
    std::vector<char> is_kept;
    for (const Index of_triangle : content.objects.of_triangle) is_kept.push_back(of_triangle == object);
    keep_triangles(content, is_kept);
    keep_vertices(content.mesh, vertices);
    content.skin.joints = rows_of(content.skin.joints, vertices);
    content.skin.weights = rows_of(content.skin.weights, vertices);
    for (MorphTarget& morph : content.morphs) morph.displacements = rows_of(morph.displacements, vertices);
    for (VertexValues& column : content.values) column.values = rows_of(column.values, vertices);
    keep_used_rows(content.normals);
    keep_used_rows(content.texture_coordinates);
    keep_used_rows(content.colors);
    keep_used_parts(content);
    content.objects = {{std::move(content.objects.names[static_cast<std::size_t>(object)])},
                       std::vector<Index>(static_cast<std::size_t>(content.mesh.n_triangles()), 0),
                       std::vector<Index>(vertices.kept.size(), 0)};
    return content;
}

}  // namespace counterpart::io
