// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/proxy.hpp"

#include "base/to_size.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/geodesic/farthest_points.hpp>

#include <algorithm>
#include <array>

namespace counterpart::surface_match {
namespace {

using Corners = std::array<Index, 3>;

// The same triangle beginning with its smallest corner.
Corners rotated(Corners corners) {
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

// Once each, and not at all where its other side is there too: cells that meet in two places fold it flat.
std::vector<Corners> dual_triangles(MeshView full, const std::vector<Index>& cell) {
    std::vector<Corners> all;
    for (Index t = 0; t < full.n_triangles(); ++t) {
        const Corners corners{cell[to_size(full.triangles(t, 0))], cell[to_size(full.triangles(t, 1))],
                              cell[to_size(full.triangles(t, 2))]};
        if (std::min({corners[0], corners[1], corners[2]}) < 0 || corners[0] == corners[1] ||
            corners[1] == corners[2] || corners[2] == corners[0])
            continue;
        all.push_back(rotated(corners));
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::vector<Corners> kept;
    for (const Corners& corners : all)
        if (!std::binary_search(all.begin(), all.end(), Corners{corners[0], corners[2], corners[1]}))
            kept.push_back(corners);
    return kept;
}

}  // namespace

Proxy make_proxy(MeshView full, Index n_vertices, const ProgressRange& progress) {
    const DistanceGraph graph(full);
    progress.reach(0.2);
    const FarthestPointSamples samples = farthest_point_samples(
        full, graph, {.count = n_vertices, .progress = progress.part(0.2, 0.9).callback()});
    const std::vector<Corners> triangles = dual_triangles(full, samples.sample_of_vertex);
    Proxy proxy;
    std::vector<Index> number(samples.vertices.size(), -1);
    proxy.mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            const Index sample = triangles[t][c];
            if (number[to_size(sample)] < 0) {
                number[to_size(sample)] = static_cast<Index>(proxy.full_of_proxy.size());
                proxy.full_of_proxy.push_back(samples.vertices[to_size(sample)]);
            }
            proxy.mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(c)) =
                number[to_size(sample)];
        }
    }
    proxy.mesh.vertices = full.vertices(proxy.full_of_proxy, Eigen::all);
    if (triangles.empty()) return proxy;
    // A cell that is in no triangle goes to the vertices nearest in space.
    const numerics::NearestNeighbors nearest(proxy.mesh.vertices);
    for (Index v = 0; v < full.n_vertices(); ++v) {
        const Index sample = samples.sample_of_vertex[to_size(v)],
                    own = sample < 0 ? -1 : number[to_size(sample)];
        proxy.cell_of_full.push_back(own >= 0 ? own : nearest.closest(full.vertices.row(v)).index);
    }
    progress.reach(1);
    return proxy;
}

}  // namespace counterpart::surface_match
