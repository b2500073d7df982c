// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace counterpart {

/// The rotation R (determinant +1) that maximizes trace(R^T M): for M = sum of y x^T the one that best turns
/// the vectors x into the vectors y (Kabsch 1976). `rank` tells how far it is determined: 2 or 3 = wholly.
struct FittedRotation {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    int rank = 0;  ///< singular values above 1e-9 of the largest
};
FittedRotation fit_rotation(const Eigen::Matrix3d& covariance);

/// The same, found from a guess that is near, in two or three steps: the iteration of Muller, Bender,
/// Chentanez, Macklin, "A Robust Method to Extract the Rotational Part of Deformations", MIG 2016, with
/// Newton's step in place of the gradient where that is safe. Ten times faster than an SVD when warm.
Eigen::Quaterniond follow_rotation(const Eigen::Matrix3d& covariance, Eigen::Quaterniond guess);

/// exp of the rotation vector (axis times angle, radians).
Eigen::Quaterniond rotation_from_vector(const Eigen::Vector3d& vector);
/// The rotation vector of length at most pi.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

}  // namespace counterpart
