// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "numerics/closest_triangle.hpp"
#include "transfer/fans.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/transfer/project.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

using Corners = std::array<Index, 3>;

Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

// For each source vertex whether all triangles around it go to triangles of the target; all false if less
// than `least_share` of the triangles do.
std::vector<char> exact_vertices(const TriangleMesh& source, const TriangleMesh& target, const VertexMap& map,
                                 double least_share) {
    std::vector<Corners> known;
    known.reserve(static_cast<std::size_t>(target.n_triangles()));
    for (Index t = 0; t < target.n_triangles(); ++t)
        known.push_back(sorted({target.triangles(t, 0), target.triangles(t, 1), target.triangles(t, 2)}));
    std::sort(known.begin(), known.end());
    std::vector<char> exact(static_cast<std::size_t>(source.n_vertices()), 1);
    Index kept = 0;
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const Corners image =
            sorted({map[source.triangles(t, 0)], map[source.triangles(t, 1)], map[source.triangles(t, 2)]});
        if (std::binary_search(known.begin(), known.end(), image)) {
            ++kept;
            continue;
        }
        for (const Index v : source.triangles.row(t)) exact[static_cast<std::size_t>(v)] = 0;
    }
    if (kept < least_share * source.n_triangles()) std::fill(exact.begin(), exact.end(), 0);
    return exact;
}

// The vertex itself first, then ring by ring.
std::vector<Index> neighborhood(const Adjacency& adjacency, Index vertex, int rings) {
    std::vector<Index> found{vertex};
    std::size_t begin = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const std::size_t end = found.size();
        for (; begin < end; ++begin) {
            for (const Index w : adjacency.neighbors(found[begin]))
                if (std::find(found.begin(), found.end(), w) == found.end()) found.push_back(w);
        }
    }
    return found;
}

// Where the vertex goes by a linear fit, over the tangent plane at `vertex`, through the images of its
// neighbours (matched ones, the vertex first).
Eigen::Vector3d fitted_image(const TriangleMesh& source, const Eigen::RowVector3d& normal,
                             const std::vector<Index>& neighbors, const Points& images, Index vertex) {
    const Eigen::RowVector3d center = source.vertices.row(vertex);
    const Eigen::RowVector3d x_axis = normal.unitOrthogonal(), y_axis = normal.cross(x_axis);
    double farthest = 0;
    for (const Index w : neighbors)
        farthest = std::max(farthest, (source.vertices.row(w) - center).squaredNorm());
    if (neighbors.size() < 4 || farthest == 0) return images.row(vertex).transpose();
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
    for (const Index w : neighbors) {
        const Eigen::RowVector3d offset = source.vertices.row(w) - center;
        const double weight = std::exp(-2 * offset.squaredNorm() / farthest);
        const Eigen::Vector3d basis(1, offset.dot(x_axis), offset.dot(y_axis));
        normal_matrix += weight * basis * basis.transpose();
        right += weight * basis * images.row(w);
    }
    // A little damping, for neighbours on a line.
    normal_matrix(1, 1) += 1e-9 * farthest;
    normal_matrix(2, 2) += 1e-9 * farthest;
    const Eigen::Matrix3d fit = normal_matrix.ldlt().solve(right);
    return fit.row(0).transpose();
}

SurfacePoint closest_among(const std::vector<Index>& triangles, const TriangleMesh& target,
                           const Eigen::Vector3d& query) {
    ClosestPoint best;
    for (const Index t : triangles) {
        ClosestPoint point = closest_on_triangle(query, target.vertices.row(target.triangles(t, 0)),
                                                 target.vertices.row(target.triangles(t, 1)),
                                                 target.vertices.row(target.triangles(t, 2)));
        point.triangle = t;
        if (point.squared_distance < best.squared_distance) best = point;
    }
    return {best.triangle, best.weights};
}

void require_usable(const ProjectOptions& options) {
    if (options.rings < 1 || options.rings > 5)
        throw InvalidInput(fmt::format("rings must be in 1 .. 5, not {}", options.rings));
    if (!(options.exact_share >= 0 && options.exact_share <= 1))
        throw InvalidInput(fmt::format("exact_share must be in 0 .. 1, not {}", options.exact_share));
}

}  // namespace

SurfaceMap project_map(const TriangleMesh& source, const TriangleMesh& target,
                       const VertexMap& target_from_source, const ProjectOptions& options) {
    require_valid(source);
    require_valid(target);
    require_usable(options);
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    SurfaceMap result = surface_map_of(target_from_source, target);
    const std::vector<char> exact = exact_vertices(source, target, target_from_source, options.exact_share);
    const Adjacency adjacency(source), target_adjacency(target);
    const Fans fans(target.triangles, target.n_vertices());
    const Points normals = vertex_normals(source);
    const Points images = image_positions(result, target);
    const SurfaceMap start = result;
    with_threads(options.n_threads, [&] {
        parallel_for(result.image.size(), 64, [&](std::size_t i) {
            const auto v = static_cast<Index>(i);
            if (exact[i] || !start.image[i].matched() || normals.row(v).isZero()) return;
            std::vector<Index> neighbors = neighborhood(adjacency, v, options.rings);
            std::erase_if(neighbors, [&](Index w) { return !start[w].matched(); });
            std::set<Index> near;  // target vertices whose triangles may hold the image
            for (const Index w : neighbors) near.insert(target_from_source[w]);
            for (const Index w : target_adjacency.neighbors(target_from_source[v])) near.insert(w);
            std::vector<Index> candidates;
            for (const Index w : near) {
                const auto around = fans.around(w);
                candidates.insert(candidates.end(), around.begin(), around.end());
            }
            std::sort(candidates.begin(), candidates.end());
            candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
            const Eigen::Vector3d image = fitted_image(source, normals.row(v), neighbors, images, v);
            result.image[i] = closest_among(candidates, target, image);
        });
    });
    return result;
}

SurfaceMap invert(const SurfaceMap& target_from_source, const TriangleMesh& source,
                  const TriangleMesh& target, const InvertOptions& options) {
    require_valid(source);
    require_valid(target);
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    if (!(options.reach > 0)) throw InvalidInput("reach must be above 0");

    constexpr Index nobody = -1, several = -2;
    std::vector<Index> only_source(static_cast<std::size_t>(target.n_vertices()), nobody);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const SurfacePoint& point = target_from_source[v];
        Eigen::Index corner = 0;
        if (!point.matched() || point.weights.maxCoeff(&corner) != 1) continue;
        Index& who = only_source[static_cast<std::size_t>(target.triangles(point.triangle, corner))];
        who = who == nobody ? v : several;
    }
    VertexMap back{std::move(only_source), source.n_vertices()};
    for (Index& v : back.image) v = std::max(v, VertexMap::unmatched);
    SurfaceMap result = surface_map_of(back, source);

    const Points images = image_positions(target_from_source, target);
    std::vector<Index> whole;
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const auto matched = [&](int c) { return target_from_source[source.triangles(t, c)].matched(); };
        if (matched(0) && matched(1) && matched(2)) whole.push_back(t);
    }
    const ClosestTriangle closest(images, Triangles(source.triangles(whole, Eigen::all)));
    const Points normals = vertex_normals(target);
    const double reach = options.reach * mean_edge_length(target);
    with_threads(options.n_threads, [&] {
        parallel_for(result.image.size(), 64, [&](std::size_t w) {
            if (result.image[w].matched()) return;
            const auto row = static_cast<Eigen::Index>(w);
            const Eigen::Vector3d query = target.vertices.row(row).transpose();
            ClosestPoint point = closest.closest(query, normals.row(row).transpose(), 0, reach);
            if (point.triangle < 0) point = closest.closest(query, reach);
            if (point.triangle >= 0)
                result.image[w] = {whole[static_cast<std::size_t>(point.triangle)], point.weights};
        });
    });
    return result;
}

}  // namespace counterpart
