// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The only door to dense factorizations: each file that instantiates Eigen's takes seconds longer.
#pragma once

#include "numerics/product_search.hpp"

namespace counterpart::numerics {

/// matrix^-1 right of a symmetric positive semidefinite matrix, of which the lower half is read, by L D L^T
/// with pivoting. O(n^3).
Eigen::Matrix3d solve_symmetric(const Eigen::Matrix3d& matrix, const Eigen::Matrix3d& right);
Eigen::VectorXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
Eigen::MatrixXd solve_symmetric(const Eigen::MatrixXd& matrix, const Eigen::MatrixXd& right);

/// The same of a positive definite matrix by L L^T, twice as fast.
Eigen::VectorXd solve_positive_definite(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right);
MatrixF solve_positive_definite(const Eigen::MatrixXf& matrix, const Eigen::MatrixXf& right);

/// What the columns of a matrix span, by QR with pivoting; rank-deficient where a pivot is below `threshold`
/// of the largest.
struct ColumnSpace {
    Eigen::Index rank = 0;
    Eigen::MatrixXd basis;           ///< orthonormal; the first `rank` columns span it, the others the rest
    Eigen::MatrixXd pseudo_inverse;  ///< of the matrix, to machine precision
};
ColumnSpace column_space(const Eigen::MatrixXd& matrix, double threshold);

}  // namespace counterpart::numerics
