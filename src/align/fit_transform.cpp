// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/moments.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>

#include <Eigen/LU>
#include <fmt/format.h>

namespace counterpart {
namespace {

// The number of directions in which the points spread, from their 3 x 3 moment matrix.
int spread(const Eigen::Matrix3d& moments) {
    const Eigen::Vector3d values = numerics::symmetric_eigen(moments).values;
    int directions = 0;
    for (int i = 0; i < 3; ++i) directions += values[i] > 1e-12 * values[2] && values[i] > 0 ? 1 : 0;
    return directions;
}

}  // namespace

Affine fit_transform(PointsView source, PointsView target, TransformModel model, const Vector& weights) {
    const Eigen::Index count = source.rows();
    const Eigen::Index least = model == TransformModel::affine ? 4 : 3;
    if (target.rows() != count || (weights.size() != 0 && weights.size() != count))
        throw InvalidInput("fit: source, target and weights must have the same number of rows");
    if (count < least)
        throw InvalidInput(
            fmt::format("fit: {} pairs of points are too few; at least {} are needed", count, least));
    if (!source.allFinite() || !target.allFinite() || (weights.size() > 0 && !(weights.minCoeff() >= 0)))
        throw InvalidInput("fit: points must be finite and weights at least 0");
    const Vector w = weights.size() > 0 ? weights : Vector::Ones(count);
    const double total = w.sum();
    if (!(total > 0)) throw InvalidInput("fit: the weights sum to zero");
    const Eigen::RowVector3d source_mean = numerics::weighted_mean(source, w);
    const Eigen::RowVector3d target_mean = numerics::weighted_mean(target, w);
    const Points x = source.rowwise() - source_mean, y = target.rowwise() - target_mean;
    const Eigen::Matrix3d moments = numerics::cross_moments(x, w, x);
    const Eigen::Matrix3d covariance = numerics::cross_moments(y, w, x);

    if (model == TransformModel::affine) {
        if (spread(moments) < 3)
            throw InvalidInput(
                "fit: the source points lie in a plane; an affine transform is not determined");
        const Eigen::Matrix3d linear = covariance * moments.inverse();
        if (!(linear.determinant() > 0)) {
            throw InvalidInput(
                "fit: the best affine transform is a reflection or flattens the mesh; check the "
                "map, or mirror one mesh");
        }
        return {linear, target_mean.transpose() - linear * source_mean.transpose()};
    }
    if (spread(moments) < 2)
        throw InvalidInput("fit: the source points lie on a line; the rotation is not determined");
    const bool with_scale = model == TransformModel::similarity;
    if (with_scale && covariance.isZero(0)) throw InvalidInput("fit: no positive scale fits these points");
    const Similarity best = kabsch(source, target, w, {.with_scale = with_scale});
    return {best.scale * best.rotation, best.translation};
}

}  // namespace counterpart
