// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The only door to dense eigenproblems: each file that instantiates Eigen's solvers takes ten seconds longer.
#pragma once

#include <Eigen/Core>

namespace counterpart::numerics {

/// Values increasing, vectors in columns, orthonormal.
template <class Matrix, class Vector>
struct SymmetricEigen {
    Vector values;
    Matrix vectors;
};

SymmetricEigen<Eigen::Matrix3d, Eigen::Vector3d> symmetric_eigen(const Eigen::Matrix3d& matrix);
SymmetricEigen<Eigen::MatrixXd, Eigen::VectorXd> symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Of matrix * x = value * mass * x; `mass` is positive definite, vectors are orthonormal by it. Throws
/// NumericalError where that does not converge.
SymmetricEigen<Eigen::MatrixXd, Eigen::VectorXd> symmetric_eigen(const Eigen::MatrixXd& matrix,
                                                                 const Eigen::MatrixXd& mass);

/// The values alone, increasing, in closed form: ten times faster, to half of the digits.
Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix);

}  // namespace counterpart::numerics
