// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/polygons.hpp"

#include "mesh/ear_cutting.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

std::vector<Index> Polygons::triangle_corners() const {
    std::vector<Index> found(at(n_corners()), -1);
    for (Eigen::Index i = corners.size(); i-- > 0;) found[at(corners(i / 3, i % 3))] = static_cast<Index>(i);
    return found;
}

TriangleMesh cut_into_triangles(PointsView vertices, std::span<const Index> sizes,
                                std::span<const Index> corners) {
    std::int64_t n_corners = 0;
    bool only_triangles = true;
    for (const Index size : sizes) {
        if (size < 3) throw InvalidInput(fmt::format("a polygon needs at least 3 corners, not {}", size));
        n_corners += size;
        only_triangles &= size == 3;
    }
    if (n_corners != std::ssize(corners))
        throw InvalidInput(
            fmt::format("the polygons have {} corners, but {} are given", n_corners, corners.size()));
    for (const Index v : corners)
        if (v < 0 || v >= vertices.rows())
            throw InvalidInput(fmt::format("a polygon names vertex {}, but vertices run from 0 to {}", v,
                                           vertices.rows() - 1));
    TriangleMesh mesh{vertices, {}};
    if (only_triangles) {
        mesh.triangles = Eigen::Map<const Triangles>(corners.data(), std::ssize(sizes), 3);
        return mesh;
    }
    const auto n_triangles = static_cast<Eigen::Index>(n_corners) - 2 * std::ssize(sizes);
    mesh.triangles.resize(n_triangles, 3);
    mesh.polygons.corners.resize(n_triangles, 3);
    mesh.polygons.first = {0};
    mesh.polygons.first.reserve(sizes.size() + 1);
    Eigen::Index t = 0;
    for (const Index size : sizes) {
        const Index first = mesh.polygons.first.back();
        const auto polygon = corners.subspan(at(first), at(size));
        for (const std::array<Index, 3>& triangle : mesh::cut_polygon(vertices, polygon)) {
            for (int c = 0; c < 3; ++c) {
                mesh.triangles(t, c) = polygon[at(triangle[at(c)])];
                mesh.polygons.corners(t, c) = first + triangle[at(c)];
            }
            ++t;
        }
        mesh.polygons.first.push_back(first + size);
    }
    return mesh;
}

void mesh::require_valid_polygons(MeshView whole) {
    const Polygons& polygons = *whole.polygons;
    const auto refuse = [](Index p, const char* what) {
        throw InvalidInput(fmt::format("polygon {} {}", p, what));
    };
    if (polygons.first.empty() || polygons.first[0] != 0 ||
        polygons.corners.rows() != whole.triangles.rows() ||
        std::int64_t{polygons.n_corners()} - 2 * std::int64_t{polygons.count()} != whole.n_triangles())
        throw InvalidInput("the polygons are not those of the triangles: n corners make n - 2 triangles");
    std::vector<Index> vertex(at(polygons.n_corners()), -1);
    for (Index p = 0; p < polygons.count(); ++p) {
        const Index begin = polygons.first[at(p)], end = polygons.first[at(p) + 1];
        if (end - begin < 3 || end > polygons.n_corners()) refuse(p, "has fewer than 3 corners");
        for (Index t = begin - 2 * p; t < end - 2 * (p + 1); ++t) {
            for (int c = 0; c < 3; ++c) {
                const Index corner = polygons.corners(t, c);
                if (corner < begin || corner >= end) refuse(p, "has a triangle with corners of another one");
                Index& known = vertex[at(corner)];
                if (known >= 0 && known != whole.triangles(t, c))
                    refuse(p, "has triangles that disagree about the vertex at a corner");
                known = whole.triangles(t, c);
            }
        }
        if (std::find(vertex.begin() + begin, vertex.begin() + end, -1) != vertex.begin() + end)
            refuse(p, "has a corner without a triangle");
    }
}

TriangleMesh mesh::coned(MeshView whole) {
    const Polygons& polygons = *whole.polygons;
    const Index n = whole.n_vertices();
    const std::vector<Index> triangle_corner = polygons.triangle_corners();
    TriangleMesh cone{Points(n + polygons.count(), 3), Triangles(polygons.n_corners(), 3)};
    cone.vertices.topRows(n) = whole.vertices;
    for (Index p = 0; p < polygons.count(); ++p) {
        const Index begin = polygons.first[at(p)], end = polygons.first[at(p) + 1];
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (Index j = begin; j < end; ++j) {
            const Index v = whole.triangles.data()[triangle_corner[at(j)]];
            cone.triangles(j, 0) = v;
            cone.triangles(j == begin ? end - 1 : j - 1, 1) = v;
            cone.triangles(j, 2) = n + p;
            sum += whole.vertices.row(v);
        }
        cone.vertices.row(n + p) = sum / (end - begin);
    }
    return cone;
}

std::string mesh::first_difference(const Polygons& source, const Polygons& target) {
    if (source.count() != target.count())
        return fmt::format("the source has {} polygons, the target {}", source.count(), target.count());
    const auto sorted_sizes = [](const Polygons& polygons) {
        std::vector<Index> sizes;
        sizes.reserve(at(polygons.count()));
        for (Index p = 0; p < polygons.count(); ++p) sizes.push_back(polygons.size(p));
        if (!std::is_sorted(sizes.begin(), sizes.end())) std::sort(sizes.begin(), sizes.end());
        return sizes;
    };
    const std::vector<Index> ours = sorted_sizes(source), theirs = sorted_sizes(target);
    const auto differ = std::mismatch(ours.begin(), ours.end(), theirs.begin());
    if (differ.first == ours.end()) return {};
    const Index size = std::min(*differ.first, *differ.second);
    return fmt::format("the source has {} polygons of {} corners, the target {}",
                       std::count(ours.begin(), ours.end(), size), size,
                       std::count(theirs.begin(), theirs.end(), size));
}

}  // namespace counterpart
