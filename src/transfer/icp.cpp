// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/fit_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace counterpart {
namespace {

void require_usable(const TriangleMesh& source, const TriangleMesh& target, const SurfaceMap& known,
                    const IcpOptions& options) {
    require_valid(source);
    require_valid(target);
    if (known.source_size() > 0) require_valid(known, source.n_vertices(), target.n_triangles());
    if (options.most_iterations < 1 || options.most_iterations > 10000)
        throw InvalidInput("icp: most_iterations must be in 1 .. 10000");
    if (!(options.trim >= 0 && options.trim <= 0.9)) throw InvalidInput("icp: trim must be in 0 .. 0.9");
    if (!(options.known_weight >= 0) || !(options.tolerance >= 0))
        throw InvalidInput("icp: known_weight and tolerance must not be negative");
}

// 1 for the closest pairs, 0 for the `trim` share that is farthest away.
Vector kept_pairs(const Vector& squared_distances, double trim) {
    std::vector<Index> order(static_cast<std::size_t>(squared_distances.size()));
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](Index a, Index b) {
        return squared_distances[a] != squared_distances[b] ? squared_distances[a] < squared_distances[b]
                                                            : a < b;
    });
    Vector weights = Vector::Zero(squared_distances.size());
    const auto kept = static_cast<std::size_t>(std::ceil((1 - trim) * static_cast<double>(order.size())));
    for (std::size_t i = 0; i < kept; ++i) weights[order[i]] = 1;
    return weights;
}

}  // namespace

IcpResult icp(const TriangleMesh& source, const TriangleMesh& target, const Transform& start,
              const SurfaceMap& known, const IcpOptions& options) {
    require_usable(source, target, known, options);
    std::vector<Index> pairs;
    for (Index v = 0; v < known.source_size(); ++v)
        if (known[v].matched()) pairs.push_back(v);
    const Eigen::Index count = source.n_vertices(), n_known = static_cast<Eigen::Index>(pairs.size());
    Points from(count + n_known, 3), to(count + n_known, 3);
    from.topRows(count) = source.vertices;
    if (n_known > 0) {
        from.bottomRows(n_known) = source.vertices(pairs, Eigen::all);
        to.bottomRows(n_known) = image_positions(known, target)(pairs, Eigen::all);
    }
    const ClosestTriangle closest(target.vertices, target.triangles);
    const double size = (target.vertices.colwise().maxCoeff() - target.vertices.colwise().minCoeff()).norm();

    IcpResult result{start};
    Vector squared(count), weights(count + n_known);
    Points moved = start(source.vertices);
    with_threads(options.n_threads, [&] {
        while (!result.converged && result.iterations < options.most_iterations) {
            parallel_for(static_cast<std::size_t>(count), 64, [&](std::size_t i) {
                const auto v = static_cast<Eigen::Index>(i);
                const ClosestPoint point = closest.closest(moved.row(v).transpose());
                to.row(v) = closest.position(point).transpose();
                squared[v] = point.squared_distance;
            });
            weights.head(count) = kept_pairs(squared, options.trim);
            const double found = weights.head(count).sum();
            result.rms_distance = std::sqrt(weights.head(count).dot(squared) / found);
            if (n_known > 0)
                weights.tail(n_known).setConstant(options.known_weight * found /
                                                  static_cast<double>(n_known));
            result.target_from_source = fit_transform(from, to, options.model, weights);
            const Points next = result.target_from_source(source.vertices);
            result.converged = (next - moved).rowwise().norm().maxCoeff() <= options.tolerance * size;
            moved = next;
            ++result.iterations;
        }
    });
    return result;
}

}  // namespace counterpart
