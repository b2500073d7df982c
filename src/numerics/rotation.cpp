// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/rotation.hpp"

#include <cmath>

#include <Eigen/SVD>

namespace counterpart::numerics {

FittedRotation fit_rotation(const Eigen::Matrix3d& covariance) {
    if (!covariance.allFinite()) return {};  // Eigen would leave its matrices unset
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d signs = Eigen::Matrix3d::Identity();
    signs(2, 2) = svd.matrixU().determinant() * svd.matrixV().determinant() < 0 ? -1 : 1;
    const Eigen::Vector3d& singular = svd.singularValues();
    FittedRotation fit{svd.matrixU() * signs * svd.matrixV().transpose(), 0};
    for (int i = 0; i < 3; ++i) fit.rank += singular[i] > 1e-9 * singular[0] ? 1 : 0;
    return fit;
}

Eigen::Quaterniond follow_rotation(const Eigen::Matrix3d& covariance, Eigen::Quaterniond guess) {
    constexpr int most_steps = 20;
    constexpr double close_enough = 1e-4;  // radians; the step leaves its square
    for (int step = 0; step < most_steps; ++step) {
        const Eigen::Matrix3d stretch = covariance * guess.toRotationMatrix().transpose();
        const Eigen::Vector3d torque(stretch(2, 1) - stretch(1, 2), stretch(0, 2) - stretch(2, 0),
                                     stretch(1, 0) - stretch(0, 1));
        const double trace = stretch.trace();
        const Eigen::Matrix3d stiffness =
            trace * Eigen::Matrix3d::Identity() - 0.5 * (stretch + stretch.transpose());
        // Newton's step where the trace is concave, else the scaled gradient of the paper.
        const double determinant = stiffness.determinant();
        const bool concave = stiffness(0, 0) > 0 && determinant > 1e-9 * std::abs(trace * trace * trace) &&
                             stiffness(0, 0) * stiffness(1, 1) > stiffness(0, 1) * stiffness(0, 1);
        Eigen::Vector3d turn = Eigen::Vector3d::Zero();
        if (concave)
            turn = stiffness.inverse() * torque;
        else if (trace != 0)
            turn = torque / std::abs(trace);
        const double angle = turn.norm();
        if (angle > 1) turn /= angle;
        guess = (Eigen::Quaterniond(1, turn[0] / 2, turn[1] / 2, turn[2] / 2) * guess).normalized();
        if (angle < close_enough) break;
    }
    return guess;
}

Eigen::Quaterniond shortest_rotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const Eigen::Vector3d a = from.normalized(), b = to.normalized();
    Eigen::Quaterniond rotation;
    rotation.w() = 1 + a.dot(b);
    rotation.vec() = a.cross(b);
    // Eigen's FromTwoVectors decomposes a matrix for the axis of opposite directions: seconds to compile.
    constexpr double opposite = 1e-12;
    if (rotation.w() < opposite) rotation.vec() = a.unitOrthogonal();
    return rotation.normalized();
}

Eigen::Quaterniond rotation_from_vector(const Eigen::Vector3d& vector) {
    const double angle = vector.norm();
    const double factor = angle > 1e-8 ? std::sin(angle / 2) / angle : 0.5;
    Eigen::Quaterniond rotation;
    rotation.w() = std::cos(angle / 2);
    rotation.vec() = factor * vector;
    return rotation.normalized();
}

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& rotation) {
    const double sine = rotation.vec().norm();
    const double angle = 2 * std::atan2(sine, std::abs(rotation.w()));
    const double factor = sine > 1e-12 ? angle / sine : 2;
    return (rotation.w() < 0 ? -factor : factor) * rotation.vec();
}

}  // namespace counterpart::numerics
