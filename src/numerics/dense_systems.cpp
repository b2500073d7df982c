// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/dense_systems.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace counterpart::numerics {

Eigen::Matrix3d solve_symmetric(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& right) {
    return matrix.ldlt().solve(right);
}

Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
    return matrix.ldlt().solve(right);
}

Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right) {
    return matrix.ldlt().solve(right);
}

Eigen::VectorXd solve_positive_definite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
    return matrix.llt().solve(right);
}

MatrixF solve_positive_definite(const Eigen::MatrixXf& matrix, const Eigen::MatrixXf& right) {
    return matrix.llt().solve(right);
}

ColumnSpace column_space(const Eigen::MatrixXd& matrix, double threshold) {
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
    qr.setThreshold(threshold);
    return {qr.rank(), qr.householderQ(),
            Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>(matrix).pseudoInverse()};
}

}  // namespace counterpart::numerics
