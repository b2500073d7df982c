// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/moments.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart {

Similarity align_centroids(PointsView source, PointsView target) {
    if (source.rows() == 0 || target.rows() == 0)
        throw InvalidInput("align_centroids: both point sets need at least one point");
    Similarity motion;
    motion.translation = (target.colwise().mean() - source.colwise().mean()).transpose();
    return motion;
}

Similarity kabsch(PointsView source, PointsView target, const Vector& weights, const KabschOptions& options) {
    if (source.rows() != target.rows() || source.rows() == 0)
        throw InvalidInput(fmt::format("kabsch: needs two sets of the same number of points, not {} and {}",
                                       source.rows(), target.rows()));
    if (weights.size() != 0 && weights.size() != source.rows())
        throw InvalidInput(fmt::format("kabsch: {} weights for {} points; give one per point", weights.size(),
                                       source.rows()));
    const Vector w = weights.size() == 0 ? Vector::Ones(source.rows()) : weights;
    const double total = w.sum();
    if (w.minCoeff() < 0 || !(total > 0))
        throw InvalidInput("kabsch: weights must be at least 0 and not all 0");

    const Eigen::RowVector3d source_mean = numerics::weighted_mean(source, w);
    const Eigen::RowVector3d target_mean = numerics::weighted_mean(target, w);
    const Points x = source.rowwise() - source_mean;
    const Points y = target.rowwise() - target_mean;
    Eigen::Matrix3d covariance = numerics::cross_moments(y, w, x);
    covariance += options.prior_weight * options.prior_rotation;
    Similarity motion;
    motion.rotation = numerics::fit_rotation(covariance).rotation;
    if (options.with_scale) {
        const double spread = (w.asDiagonal() * x.rowwise().squaredNorm()).sum();
        const double overlap = (w.asDiagonal() * (x * motion.rotation.transpose()).cwiseProduct(y)).sum();
        if (spread > 0 && overlap > 0) motion.scale = overlap / spread;
    }
    motion.translation = target_mean.transpose() - motion.scale * (motion.rotation * source_mean.transpose());
    return motion;
}

}  // namespace counterpart
