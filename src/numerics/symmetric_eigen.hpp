// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Eigen's solvers, compiled once: each file that instantiates them takes ten seconds longer.
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

}  // namespace counterpart::numerics
