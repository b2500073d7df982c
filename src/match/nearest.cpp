// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Sahillioglu and Yemez, "3D Correspondence by Breadth-First Search Frontiers", section 5: the naive method.
#include "base/parallel.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/match/nearest.hpp>

namespace counterpart {

NearestResult match_nearest(const TriangleMesh& source, const TriangleMesh& target,
                            const NearestOptions& options) {
    require_valid(source);
    require_valid(target);
    const Eigen::RowVector3d offset = target.vertices.colwise().mean() - source.vertices.colwise().mean();
    const NearestNeighbors neighbors(target.vertices);
    NearestResult result{
        {std::vector<Index>(static_cast<std::size_t>(source.n_vertices())), target.n_vertices()}};
    with_threads(options.n_threads, [&] {
        parallel_for(result.target_from_source.image.size(), 256, [&](std::size_t v) {
            const Eigen::RowVector3d moved = source.vertices.row(static_cast<Eigen::Index>(v)) + offset;
            result.target_from_source.image[v] = neighbors.closest(moved).index;
        });
    });
    return result;
}

}  // namespace counterpart
