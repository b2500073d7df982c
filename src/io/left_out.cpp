// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/left_out.hpp"

#include "io/kept_triangles.hpp"

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
    const Index n_before = mesh.n_triangles();
    keep_triangles(content, kept_triangles(mesh));
    return n_before - mesh.n_triangles();
}

}  // namespace counterpart::io
