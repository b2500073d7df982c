// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Sahillioglu and Yemez, "3D Correspondence by Breadth-First Search Frontiers", section 5: the naive method.
#include "base/parallel.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/match/nearest.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart {
namespace {

Affine alignment(MeshView source, MeshView target, const NearestOptions& options) {
    if (options.alignment == NearestAlignment::similarity)
        return icp_from_principal_axes(source, target,
                                       {.model = TransformModel::similarity,
                                        .max_iterations = 30,
                                        .n_threads = options.n_threads,
                                        .progress = part_of(options.progress, 0, 0.9)})
            .target_from_source;
    Affine centroids;
    centroids.translation = (target.vertices.colwise().mean() - source.vertices.colwise().mean()).transpose();
    return centroids;
}

}  // namespace

NearestResult match_nearest(MeshView source, MeshView target, const NearestOptions& options) {
    require_valid(source);
    require_valid(target);
    const Points moved = alignment(source, target, options)(source.vertices);
    const numerics::NearestNeighbors neighbors(target.vertices);
    std::vector<Index> image(static_cast<std::size_t>(source.n_vertices()));
    with_threads(options.n_threads, [&] {
        parallel_for(image.size(), 256, part_of(options.progress, 0.9, 1), [&](std::size_t v) {
            image[v] = neighbors.closest(moved.row(static_cast<Eigen::Index>(v))).index;
        });
    });
    // Only where squares of lengths overflow is no vertex the nearest.
    if (const auto lost = std::find(image.begin(), image.end(), -1); lost != image.end())
        throw UnsuitableMesh(fmt::format(
            "source vertex {} is too far from the target to measure: scale the meshes down, or look for a "
            "vertex that is far away by mistake",
            lost - image.begin()));
    return {VertexMap(std::move(image), target.n_vertices())};
}

}  // namespace counterpart
