// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "numerics/closest_triangle.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/LU>

namespace counterpart {
namespace {

void require_usable(MeshView source, MeshView target, const SurfaceMap& known, const IcpOptions& options) {
    require_valid(source);
    require_valid(target);
    if (known.source_size() > 0) require_valid(known, source.n_vertices(), target.n_triangles());
    if (options.max_iterations < 1 || options.max_iterations > 10000)
        throw InvalidInput("icp: max_iterations must be in 1 .. 10000");
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

// Rows are the principal axes of the points about their mean, the longest first, right-handed.
Eigen::Matrix3d principal_axes(PointsView centered) {
    Eigen::Matrix3d axes = numerics::symmetric_eigen(Eigen::Matrix3d(centered.transpose() * centered))
                               .vectors.transpose()
                               .colwise()
                               .reverse();
    if (axes.determinant() < 0) axes.row(2) *= -1;
    return axes;
}

// The 24 rotations that take the coordinate axes onto coordinate axes.
std::vector<Eigen::Matrix3d> axis_rotations() {
    std::vector<Eigen::Matrix3d> result;
    std::array<int, 3> order{0, 1, 2};
    do {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3d rotation = Eigen::Matrix3d::Zero();
            for (int i = 0; i < 3; ++i)
                rotation(i, order[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1 : 1;
            if (rotation.determinant() > 0) result.push_back(rotation);
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return result;
}

}  // namespace

IcpResult icp(MeshView source, MeshView target, const Affine& start, const SurfaceMap& known,
              const IcpOptions& options) {
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
    const numerics::ClosestTriangle closest(target.vertices, target.triangles);
    const double size = (target.vertices.colwise().maxCoeff() - target.vertices.colwise().minCoeff()).norm();

    IcpResult result{start};
    Vector squared(count), weights(count + n_known);
    Points moved = start(source.vertices);
    with_threads(options.n_threads, [&] {
        while (!result.converged && result.iterations < options.max_iterations) {
            parallel_for(static_cast<std::size_t>(count), 64, [&](std::size_t i) {
                const auto v = static_cast<Eigen::Index>(i);
                const numerics::ClosestPoint point = closest.closest(moved.row(v).transpose());
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
            report_progress(
                options.progress,
                result.converged ? 1 : static_cast<double>(result.iterations) / options.max_iterations);
        }
    });
    return result;
}

IcpResult icp_from_principal_axes(MeshView source, MeshView target, const IcpOptions& options) {
    require_usable(source, target, {}, options);
    const Eigen::RowVector3d source_mean = source.vertices.colwise().mean(),
                             target_mean = target.vertices.colwise().mean();
    const Points from = source.vertices.rowwise() - source_mean, to = target.vertices.rowwise() - target_mean;
    const Eigen::Matrix3d source_axes = principal_axes(from), target_axes = principal_axes(to);
    const double spread = std::sqrt(from.squaredNorm() / static_cast<double>(from.rows()));
    const bool with_scale = options.model != TransformModel::rigid && spread > 0;
    const double scale =
        with_scale ? std::sqrt(to.squaredNorm() / static_cast<double>(to.rows())) / spread : 1;

    IcpResult best;
    best.target_from_source.translation = (target_mean - source_mean).transpose();
    best.rms_distance = std::numeric_limits<double>::infinity();
    const std::vector<Eigen::Matrix3d> rotations = axis_rotations();
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        Affine start;
        start.linear = scale * target_axes.transpose() * rotations[i] * source_axes;
        start.translation = target_mean.transpose() - start.linear * source_mean.transpose();
        IcpOptions run = options;
        if (options.progress)
            run.progress = [&](double fraction) {
                return options.progress((static_cast<double>(i) + fraction) /
                                        static_cast<double>(rotations.size()));
            };
        try {
            IcpResult result = icp(source, target, start, {}, run);
            if (result.rms_distance < best.rms_distance) best = std::move(result);
        } catch (const InvalidInput&) {
            // The closest points determine no transform from this start; another may.
        }
    }
    report_progress(options.progress, 1);
    return best;
}

}  // namespace counterpart
