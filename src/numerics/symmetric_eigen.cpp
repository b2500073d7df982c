// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/symmetric_eigen.hpp"

#include <Eigen/Eigenvalues>

namespace counterpart::numerics {

SymmetricEigen<Eigen::Matrix3d, Eigen::Vector3d> symmetric_eigen(const Eigen::Matrix3d& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigen<Eigen::MatrixXd, Eigen::VectorXd> symmetric_eigen(const Eigen::MatrixXd& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace counterpart::numerics
