// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/base/errors.hpp>

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

SymmetricEigen<Eigen::MatrixXd, Eigen::VectorXd> symmetric_eigen(const Eigen::MatrixXd& matrix,
                                                                 const Eigen::MatrixXd& mass) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix, mass);
    if (solver.info() != Eigen::Success || !solver.eigenvalues().allFinite())
        throw NumericalError("the dense eigenvalue problem did not converge");
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Eigen::Vector3d symmetric_eigenvalues(const Eigen::Matrix3d& matrix) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(matrix, Eigen::EigenvaluesOnly);
    return solver.eigenvalues();
}

}  // namespace counterpart::numerics
