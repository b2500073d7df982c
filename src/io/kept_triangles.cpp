// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/kept_triangles.hpp"

namespace counterpart::io {
namespace {

Triangles rows_of(const Triangles& all, const std::vector<Index>& rows) {
    return all.rows() == 0 ? all : Triangles(all(rows, Eigen::all));
}

Polygons polygons_of(const Polygons& all, const std::vector<char>& kept,
                     const std::vector<Index>& triangles) {
    Polygons result;
    if (all.empty()) return result;
    result.first.push_back(0);
    result.corners = rows_of(all.corners, triangles);
    Index triangle = 0;  // of those that stay
    for (Index p = 0; p < all.count(); ++p) {
        if (kept[static_cast<std::size_t>(all.first_triangle(p))] == 0) continue;
        const Index moved = all.first[static_cast<std::size_t>(p)] - result.first.back();
        const Index count = all.size(p) - 2;
        result.corners.middleRows(triangle, count).array() -= moved;
        triangle += count;
        result.first.push_back(result.first.back() + all.size(p));
    }
    if (result.count() == result.corners.rows()) return {};  // only triangles are left
    return result;
}

// One entry for each triangle, or none at all.
std::vector<Index> entries_of(const std::vector<Index>& all, const std::vector<Index>& triangles) {
    std::vector<Index> result;
    if (all.empty()) return result;
    result.reserve(triangles.size());
    for (const Index t : triangles) result.push_back(all[static_cast<std::size_t>(t)]);
    return result;
}

// What no triangle names any more is in the object of those that did.
void name_objects_of_vertices(const Triangles& triangles, const std::vector<char>& kept,
                              MeshObjects& objects) {
    if (objects.of_vertex.empty()) return;
    for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t) {
        if (kept[static_cast<std::size_t>(t)] != 0) continue;
        for (const Index v : triangles.row(t))
            objects.of_vertex[static_cast<std::size_t>(v)] = objects.of_triangle[static_cast<std::size_t>(t)];
    }
}

}  // namespace

void keep_triangles(AttributedMesh& content, const std::vector<char>& kept) {
    TriangleMesh& mesh = content.mesh;
    std::vector<Index> triangles;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (kept[static_cast<std::size_t>(t)] != 0) triangles.push_back(t);
    name_objects_of_vertices(mesh.triangles, kept, content.objects);
    mesh.polygons = polygons_of(mesh.polygons, kept, triangles);
    mesh.triangles = rows_of(mesh.triangles, triangles);
    content.normals.corners = rows_of(content.normals.corners, triangles);
    for (CornerAttribute& set : content.texture_coordinates) set.corners = rows_of(set.corners, triangles);
    for (CornerAttribute& set : content.colors) set.corners = rows_of(set.corners, triangles);
    content.parts = entries_of(content.parts, triangles);
    content.objects.of_triangle = entries_of(content.objects.of_triangle, triangles);
}

}  // namespace counterpart::io
