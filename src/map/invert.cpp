// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "mesh/fans.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Source triangles whose images bridge a tear: one of their edges is far longer than the map's stretch
// explains.
std::vector<char> torn_triangles(MeshView source, PointsView images, MeshView target) {
    const double scale = std::sqrt(surface_area(target) / surface_area(source));
    const double allowance = 2 * mean_edge_length(target);
    constexpr double most_stretch = 4;
    std::vector<char> torn(static_cast<std::size_t>(source.n_triangles()), 0);
    for (Index t = 0; t < source.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index a = source.triangles(t, c), b = source.triangles(t, (c + 1) % 3);
            const double before = (source.vertices.row(a) - source.vertices.row(b)).norm();
            const double after = (images.row(a) - images.row(b)).norm();
            // Written so that NaN, an unmatched corner, counts too.
            if (!(after <= most_stretch * scale * before + allowance)) torn[static_cast<std::size_t>(t)] = 1;
        }
    }
    return torn;
}

// Finds the source triangles whose images are near a target vertex along the target's surface, so that a hand
// that touches the hip is not taken for it.
class SourceNearby {
  public:
    TriangleMesh laid_out;  // the source at its images

    SourceNearby(const SurfaceMap& map, MeshView source, MeshView target)
        : laid_out{image_positions(map, target), source.triangles},
          torn_(torn_triangles(source, laid_out.vertices, target)),
          adjacency_(target),
          source_fans_(source.triangles, source.n_vertices()),
          landed_(static_cast<std::size_t>(target.n_vertices())) {
        const VertexMap nearest = nearest_corners(map, target);
        for (Index v = 0; v < source.n_vertices(); ++v)
            if (nearest[v] != VertexMap::unmatched)
                landed_[static_cast<std::size_t>(nearest[v])].push_back(v);
    }

    // The triangles around the first few source vertices met when walking ring by ring from the vertex.
    std::vector<Index> triangles(Index target_vertex) const {
        constexpr std::size_t enough = 8, most_visited = 2000;
        std::vector<Index> ring{target_vertex}, sources;
        std::set<Index> visited{target_vertex};
        while (!ring.empty() && sources.size() < enough && visited.size() < most_visited) {
            std::vector<Index> next;
            for (const Index w : ring) {
                const std::vector<Index>& here = landed_[static_cast<std::size_t>(w)];
                sources.insert(sources.end(), here.begin(), here.end());
                for (const Index u : adjacency_.neighbors(w))
                    if (visited.insert(u).second) next.push_back(u);
            }
            ring = std::move(next);
        }
        std::set<Index> found;
        for (const Index v : sources) {
            for (const Index t : source_fans_.around(v))
                if (!torn_[static_cast<std::size_t>(t)]) found.insert(t);
        }
        return {found.begin(), found.end()};
    }

  private:
    std::vector<char> torn_;
    Adjacency adjacency_;
    mesh::Fans source_fans_;
    std::vector<std::vector<Index>> landed_;  // source vertices by the target vertex nearest to their image
};

}  // namespace

SurfaceMap invert(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                  const InvertOptions& options) {
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
    for (Index& v : only_source) v = std::max(v, VertexMap::unmatched);
    const VertexMap back(std::move(only_source), source.n_vertices());
    SurfaceMap result = surface_map_of(back, source);

    const SourceNearby nearby(target_from_source, source, target);
    const double reach = options.reach * mean_edge_length(target);
    with_threads(options.n_threads, [&] {
        parallel_for(result.image.size(), 64, options.progress, [&](std::size_t w) {
            if (result.image[w].matched()) return;
            const std::vector<Index> candidates = nearby.triangles(static_cast<Index>(w));
            const Eigen::Vector3d query = target.vertices.row(static_cast<Eigen::Index>(w)).transpose();
            const numerics::ClosestPoint point = numerics::closest_among(candidates, nearby.laid_out.vertices,
                                                                         nearby.laid_out.triangles, query);
            if (point.squared_distance <= reach * reach) result.image[w] = {point.triangle, point.weights};
        });
    });
    return result;
}

MapPair with_inverse(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                     const WithInverseOptions& options) {
    if (!(options.tolerance > 0)) throw InvalidInput("tolerance must be above 0");
    if (options.rounds < 0 || options.rounds > 100)
        throw InvalidInput(fmt::format("rounds must be in 0 .. 100, not {}", options.rounds));
    // Each round inverts twice; their number is unknown in advance, and mostly one.
    double done = 0;
    const auto next = [&] {
        const double begin = done;
        done += (1 - done) / 3;
        return InvertOptions{.reach = options.reach,
                             .n_threads = options.n_threads,
                             .progress = part_of(options.progress, begin, done)};
    };
    MapPair pair{target_from_source, invert(target_from_source, source, target, next()), 0};
    const double most = options.tolerance * mean_edge_length(source);
    for (int round = 0; round < options.rounds && count_matched(pair.source_from_target) > 0; ++round) {
        const SurfaceMap back = complete_map(pair.source_from_target, target, source).target_from_source;
        const SurfaceMap again = invert(back, target, source, next());
        const Points places = image_positions(back, source);
        const Matrix returned = transfer_values(pair.target_from_source, target, places);
        const Matrix returned_again = transfer_values(again, target, places);
        pair.moved = 0;
        for (Index v = 0; v < source.n_vertices(); ++v) {
            if (!pair.target_from_source[v].matched() || !again[v].matched()) continue;
            const double off = (returned.row(v) - source.vertices.row(v)).norm();
            const double off_again = (returned_again.row(v) - source.vertices.row(v)).norm();
            if (off <= most || off_again >= off) continue;
            pair.target_from_source.image[static_cast<std::size_t>(v)] = again[v];
            ++pair.moved;
        }
        if (pair.moved == 0) break;
        pair.source_from_target = invert(pair.target_from_source, source, target, next());
    }
    return pair;
}

}  // namespace counterpart
