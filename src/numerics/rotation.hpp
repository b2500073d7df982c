// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace counterpart::numerics {

/// The rotation R (determinant +1) that maximizes trace(R^T M): for M = sum of y x^T the one that best
/// rotates the vectors x onto the vectors y (Kabsch 1976). It is fully determined if `rank` is 2 or 3.
/// Where numbers are not finite, the identity, of rank 0.
struct FittedRotation {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    int rank = 0;  ///< singular values above 1e-9 of the largest
};
FittedRotation fit_rotation(const Eigen::Matrix3d& covariance);

/// The same from an initial guess, in two or three steps if it is near: the iteration of Muller, Bender,
/// Chentanez, Macklin, "A Robust Method to Extract the Rotational Part of Deformations", MIG 2016, with
/// Newton's step in place of the gradient where that is safe. Ten times faster than an SVD when warm.
Eigen::Quaterniond follow_rotation(const Eigen::Matrix3d& covariance, Eigen::Quaterniond guess);

/// The rotation by the smallest angle that takes the direction `from` to the direction `to`, about any normal
/// axis if they are opposite.
Eigen::Quaterniond shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// exp of the rotation vector (axis times angle, radians).
Eigen::Quaterniond rotation_from_vector(const Eigen::Vector3d& vector);
/// The inverse of the above, with a length of at most pi.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation);

}  // namespace counterpart::numerics
