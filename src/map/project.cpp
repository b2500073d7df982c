// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "mesh/fans.hpp"
#include "numerics/closest_triangle.hpp"
#include "numerics/dense_systems.hpp"
#include "numerics/moments.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

using Corners = std::array<Index, 3>;

Corners sorted(Corners corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

// The triangles of the target, and whether those of the source go to them.
class Counterparts {
  public:
    Counterparts(MeshView source, MeshView target, const VertexMap& map)
        : source_(source), map_(map), around_(source.triangles, source.n_vertices()) {
        known_.reserve(static_cast<std::size_t>(target.n_triangles()));
        for (Index t = 0; t < target.n_triangles(); ++t)
            known_.push_back(
                sorted({target.triangles(t, 0), target.triangles(t, 1), target.triangles(t, 2)}));
        std::sort(known_.begin(), known_.end());
    }

    // As a triangle, or as one half of a quad that the target cuts along the other diagonal.
    bool has(Index t) const {
        const auto v = source_.triangles.row(t);
        return holds(v[0], v[1], v[2]) || is_recut(t, v[0], v[1], v[2]) || is_recut(t, v[1], v[2], v[0]) ||
               is_recut(t, v[2], v[0], v[1]);
    }

  private:
    bool holds(Index a, Index b, Index c) const {
        return std::binary_search(known_.begin(), known_.end(), sorted({map_[a], map_[b], map_[c]}));
    }

    bool is_recut(Index t, Index a, Index b, Index tip) const {
        if (a == b) return false;  // of a degenerate triangle: no edge
        for (const Index u : around_.around(a)) {
            const auto v = source_.triangles.row(u);
            const Index other = v[0] + v[1] + v[2] - a - b;
            if (u != t && (v.array() == b).any() && holds(a, tip, other) && holds(b, tip, other)) return true;
        }
        return false;
    }

    MeshView source_;
    const VertexMap& map_;
    mesh::Fans around_;
    std::vector<Corners> known_;
};

// For each source vertex whether all triangles around it have counterparts in the target; all false if less
// than `least_share` of the triangles have.
std::vector<char> exact_vertices(MeshView source, MeshView target, const VertexMap& map, double least_share) {
    const Counterparts counterparts(source, target, map);
    std::vector<char> exact(static_cast<std::size_t>(source.n_vertices()), 1);
    Index kept = 0;
    for (Index t = 0; t < source.n_triangles(); ++t) {
        if (counterparts.has(t)) {
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
// matched neighbors.
Eigen::Vector3d fitted_image(MeshView source, const Eigen::RowVector3d& normal,
                             const std::vector<Index>& neighbors, PointsView images, Index vertex) {
    const Eigen::RowVector3d center = source.vertices.row(vertex);
    const Eigen::RowVector3d x_axis = normal.unitOrthogonal(), y_axis = normal.cross(x_axis);
    double farthest = 0;
    for (const Index w : neighbors)
        farthest = std::max(farthest, (source.vertices.row(w) - center).squaredNorm());
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero(), right = Eigen::Matrix3d::Zero();
    for (const Index w : neighbors) {
        const Eigen::RowVector3d offset = source.vertices.row(w) - center;
        const double weight = std::exp(-2 * offset.squaredNorm() / farthest);
        const Eigen::Vector3d basis(1, offset.dot(x_axis), offset.dot(y_axis));
        numerics::add_outer(normal_matrix, weight, basis, basis);
        numerics::add_outer(right, weight, basis, images.row(w).transpose());
    }
    // A little damping, for neighbors on a line.
    normal_matrix(1, 1) += 1e-9 * farthest;
    normal_matrix(2, 2) += 1e-9 * farthest;
    const Eigen::Matrix3d fit = numerics::solve_symmetric(normal_matrix, right);
    return fit.row(0).transpose();
}

void require_usable(const ProjectOptions& options) {
    if (options.rings < 1 || options.rings > 5)
        throw InvalidInput(fmt::format("rings must be in 1 .. 5, not {}", options.rings));
    if (options.passes < 1 || options.passes > 100)
        throw InvalidInput(fmt::format("passes must be in 1 .. 100, not {}", options.passes));
    if (options.extend < 0 || options.extend > 1000)
        throw InvalidInput(fmt::format("extend must be in 0 .. 1000, not {}", options.extend));
    if (!(options.exact_share >= 0 && options.exact_share <= 1))
        throw InvalidInput(fmt::format("exact_share must be in 0 .. 1, not {}", options.exact_share));
}

// What stays the same over the passes.
struct Projection {
    MeshView source, &target;
    Adjacency adjacency{source}, target_adjacency{target};
    mesh::Fans fans{target.triangles, target.n_vertices()};
    Points normals = vertex_normals(source);
    int rings;

    // The triangles around the target vertices nearest to the neighbors' images, one ring more around the
    // vertex's own.
    std::vector<Index> candidates(const VertexMap& nearest, const std::vector<Index>& neighbors,
                                  Index v) const {
        std::set<Index> near;
        for (const Index w : neighbors) near.insert(nearest[w]);
        if (nearest[v] != VertexMap::unmatched)
            for (const Index w : target_adjacency.neighbors(nearest[v])) near.insert(w);
        std::vector<Index> triangles;
        for (const Index w : near) {
            const auto around = fans.around(w);
            triangles.insert(triangles.end(), around.begin(), around.end());
        }
        std::sort(triangles.begin(), triangles.end());
        triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
        return triangles;
    }

    SurfacePoint improved(const SurfaceMap& map, const VertexMap& nearest, PointsView images, Index v) const {
        std::vector<Index> neighbors = neighborhood(adjacency, v, rings);
        std::erase_if(neighbors, [&](Index w) { return !map[w].matched(); });
        constexpr std::size_t least = 4;  // three determine the fit exactly and even nothing out
        if (neighbors.size() < least || normals.row(v).isZero()) return map[v];
        const numerics::ClosestPoint point =
            numerics::closest_among(candidates(nearest, neighbors, v), target.vertices, target.triangles,
                                    fitted_image(source, normals.row(v), neighbors, images, v));
        return {point.triangle, point.weights};
    }
};

}  // namespace

SurfaceMap project_map(MeshView source, MeshView target, const VertexMap& target_from_source,
                       const ProjectOptions& options) {
    require_valid(source);
    require_valid(target);
    require_usable(options);
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    const Projection projection{.source = source, .target = target, .rings = options.rings};
    const std::vector<char> exact = exact_vertices(source, target, target_from_source, options.exact_share);
    SurfaceMap result = surface_map_of(target_from_source, target);
    with_threads(options.n_threads, [&] {
        const int n_passes = std::max(options.passes, options.extend);
        for (int pass = 0; pass < n_passes; ++pass) {
            const Progress progress = part_of(options.progress, static_cast<double>(pass) / n_passes,
                                              static_cast<double>(pass + 1) / n_passes);
            const SurfaceMap before = result;
            const VertexMap nearest = nearest_corners(before, target);
            const Points images = image_positions(before, target);
            parallel_for(result.image.size(), 64, progress, [&](std::size_t v) {
                const bool due = pass < (before.image[v].matched() ? options.passes : options.extend);
                if (due && !exact[v])
                    result.image[v] = projection.improved(before, nearest, images, static_cast<Index>(v));
            });
        }
    });
    return result;
}

}  // namespace counterpart
