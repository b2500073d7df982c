// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/left_out.hpp"

#include <algorithm>
#include <limits>

namespace counterpart::io {
namespace {

// For each triangle whether it stays; of a polygon all or none do.
std::vector<char> kept_triangles(const TriangleMesh& mesh) {
    std::vector<char> is_left_out(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (const Index v : mesh.left_out) is_left_out[static_cast<std::size_t>(v)] = 1;
    std::vector<char> kept(static_cast<std::size_t>(mesh.n_triangles()), 1);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            if (is_left_out[static_cast<std::size_t>(mesh.triangles(t, c))] != 0)
                kept[static_cast<std::size_t>(t)] = 0;
    for (Index p = 0; p < mesh.polygons.count(); ++p) {
        const auto begin = kept.begin() + mesh.polygons.first_triangle(p);
        const auto end = begin + (mesh.polygons.size(p) - 2);
        if (std::find(begin, end, 0) != end) std::fill(begin, end, char{0});
    }
    return kept;
}

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

}  // namespace

std::vector<Index> place_left_out(Points& points) {
    std::vector<Index> left_out;
    Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
    double count = 0, least = std::numeric_limits<double>::infinity(), most = -least;  // of x
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        if (!points.row(v).allFinite()) {
            left_out.push_back(static_cast<Index>(v));
            continue;
        }
        ++count;
        least = std::min(least, points(v, 0));
        most = std::max(most, points(v, 0));
        mean += points.row(v) / count - mean / count;  // no sum that could overflow
    }
    if (count == 0) return {};
    // Each a little beside the others: what lies at one place counts as a duplicate.
    const double step = 1e-6 * (most / 2 - least / 2) / static_cast<double>(left_out.size() + 1);
    for (const Index v : left_out) {
        mean[0] += step;
        points.row(v) = mean;
    }
    return left_out;
}

Index remove_faces_of_left_out(AttributedMesh& content) {
    TriangleMesh& mesh = content.mesh;
    if (mesh.left_out.empty()) return 0;
    const std::vector<char> kept = kept_triangles(mesh);
    std::vector<Index> triangles;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (kept[static_cast<std::size_t>(t)] != 0) triangles.push_back(t);
    const Index n_removed = mesh.n_triangles() - static_cast<Index>(triangles.size());
    if (n_removed == 0) return 0;
    mesh.polygons = polygons_of(mesh.polygons, kept, triangles);
    mesh.triangles = rows_of(mesh.triangles, triangles);
    content.normals.corners = rows_of(content.normals.corners, triangles);
    for (CornerAttribute& set : content.texture_coordinates) set.corners = rows_of(set.corners, triangles);
    for (CornerAttribute& set : content.colors) set.corners = rows_of(set.corners, triangles);
    if (content.parts.empty()) return n_removed;
    std::vector<Index> parts;
    for (const Index t : triangles) parts.push_back(content.parts[static_cast<std::size_t>(t)]);
    content.parts = std::move(parts);
    return n_removed;
}

}  // namespace counterpart::io
