// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Whether a path of at most `max_edges` edges leads to a matched vertex.
std::vector<char> near_matched(const SurfaceMap& map, MeshView mesh, int max_edges) {
    const Adjacency adjacency(mesh);
    std::vector<char> reached(map.image.size(), 0);
    std::vector<Index> frontier, next;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (map[v].matched()) reached[static_cast<std::size_t>(v)] = 1, frontier.push_back(v);
    for (int edges = 0; edges < max_edges && !frontier.empty(); ++edges, std::swap(frontier, next)) {
        next.clear();
        for (const Index v : frontier) {
            for (const Index w : adjacency.neighbors(v)) {
                if (reached[static_cast<std::size_t>(w)] != 0) continue;
                reached[static_cast<std::size_t>(w)] = 1;
                next.push_back(w);
            }
        }
    }
    return reached;
}

}  // namespace

CompletedMap complete_map(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                          const CompleteOptions& options) {
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    if (options.max_edges && *options.max_edges < 1)
        throw InvalidInput(fmt::format("max_edges is {}; it must be at least 1", *options.max_edges));
    CompletedMap result{target_from_source, {.transferred = count_matched(target_from_source)}};
    if (result.coverage.transferred == 0) throw InvalidInput("the map matches no vertex");
    if (result.coverage.transferred == source.n_vertices()) return result;
    const mesh::FillResult images =
        mesh::fill_everywhere(source, image_positions(target_from_source, target));
    std::vector<char> wanted(target_from_source.image.size(), 1);
    if (options.max_edges) {  // no edges lead to components without a match
        wanted = near_matched(target_from_source, source, *options.max_edges);
        result.coverage.filled =
            static_cast<Index>(std::count(wanted.begin(), wanted.end(), 1)) - result.coverage.transferred;
    } else {
        result.coverage.filled = images.filled;
        result.coverage.guessed = images.unknown;
    }
    const numerics::ClosestTriangle surface(target.vertices, target.triangles);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v].matched()) continue;
        if (wanted[static_cast<std::size_t>(v)] == 0) continue;
        const numerics::ClosestPoint point = surface.closest(images.values.row(v).transpose());
        if (!std::isfinite(point.squared_distance)) {
            throw InvalidInput(
                fmt::format("the place of vertex {} on the target is too far from it to be "
                            "measured; scale the meshes to smaller coordinates",
                            v));
        }
        result.target_from_source.image[static_cast<std::size_t>(v)] = {point.triangle, point.weights};
    }
    return result;
}

VertexMap complete_map(const VertexMap& target_from_source, MeshView source, MeshView target,
                       const CompleteOptions& options) {
    const VertexMap corners = nearest_corners(
        complete_map(surface_map_of(target_from_source, target), source, target, options).target_from_source,
        target);
    std::vector<Index> image = target_from_source.image();
    for (std::size_t v = 0; v < image.size(); ++v)
        if (image[v] == VertexMap::unmatched) image[v] = corners[static_cast<Index>(v)];
    return {std::move(image), target.n_vertices()};
}

}  // namespace counterpart
