// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Sums over points, compiled once: of products of three factors the compiler instantiates hundreds of
// templates.
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart::numerics {

/// Sum of weights[i] * points_i over the sum of the weights.
Eigen::RowVector3d weighted_mean(PointsView points, const Vector& weights);

/// Sum of a_i^T b_i, and of weights[i] * a_i^T b_i: 3 x 3, the rows those of a.
Eigen::Matrix3d cross_moments(PointsView a, PointsView b);
Eigen::Matrix3d cross_moments(PointsView a, const Vector& weights, PointsView b);

/// sum += weight * a b^T.
inline void add_outer(Eigen::Matrix3d& sum, double weight, const Eigen::Vector3d& a,
                      const Eigen::Vector3d& b) {
    const double x = weight * a[0], y = weight * a[1], z = weight * a[2];
    for (int j = 0; j < 3; ++j) {
        sum(0, j) += x * b[j];
        sum(1, j) += y * b[j];
        sum(2, j) += z * b[j];
    }
}

}  // namespace counterpart::numerics
