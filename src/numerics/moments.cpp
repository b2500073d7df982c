// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/moments.hpp"

namespace counterpart::numerics {

Eigen::RowVector3d weighted_mean(PointsView points, const Vector& weights) {
    return (weights.transpose() * points) / weights.sum();
}

Eigen::Matrix3d cross_moments(PointsView a, PointsView b) { return a.transpose() * b; }

Eigen::Matrix3d cross_moments(PointsView a, const Vector& weights, PointsView b) {
    return a.transpose() * weights.asDiagonal() * b;
}

}  // namespace counterpart::numerics
