// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/dense_systems.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols) {
    Random random(3);
    return Eigen::MatrixXd::NullaryExpr(rows, cols, [&] { return random.uniform(-1, 1); });
}

TEST(DenseSystems, SolutionsSatisfyTheEquations) {
    const Eigen::MatrixXd half = random_matrix(6, 6), right = random_matrix(6, 2);
    const Eigen::MatrixXd matrix = half * half.transpose();
    EXPECT_LT((matrix * solve_symmetric(matrix, right) - right).norm(), 1e-9);
    const Eigen::VectorXd column = right.col(0);
    EXPECT_LT((matrix * solve_symmetric(matrix, column) - column).norm(), 1e-9);
    EXPECT_LT((matrix * solve_positive_definite(matrix, column) - column).norm(), 1e-9);

    const Eigen::MatrixXf single = matrix.cast<float>(), single_right = right.cast<float>();
    EXPECT_LT((single * solve_positive_definite(single, single_right) - single_right).norm(), 1e-2F);
    const Eigen::Matrix3d small = matrix.topLeftCorner<3, 3>(), images = half.topLeftCorner<3, 3>();
    EXPECT_LT((small * solve_symmetric(small, images) - images).norm(), 1e-9);
}

TEST(DenseSystems, TheUpperHalfIsNotRead) {
    const Eigen::MatrixXd half = random_matrix(5, 5), right = random_matrix(5, 1);
    const Eigen::MatrixXd matrix = half * half.transpose();
    Eigen::MatrixXd lower = matrix.triangularView<Eigen::Lower>();
    EXPECT_EQ(solve_symmetric(lower, right), solve_symmetric(matrix, right));
}

TEST(DenseSystems, ColumnSpaceOfDependentColumns) {
    Eigen::MatrixXd matrix = random_matrix(7, 3);
    matrix.col(2) = matrix.col(0) - 2 * matrix.col(1);
    const ColumnSpace space = column_space(matrix, 1e-10);
    EXPECT_EQ(space.rank, 2);
    EXPECT_LT((space.basis.transpose() * space.basis - Eigen::MatrixXd::Identity(7, 7)).norm(), 1e-12);
    EXPECT_LT((space.basis.rightCols(5).transpose() * matrix).norm(), 1e-12);
    // Moore and Penrose's conditions.
    const Eigen::MatrixXd& inverse = space.pseudo_inverse;
    EXPECT_LT((matrix * inverse * matrix - matrix).norm(), 1e-12);
    EXPECT_LT((inverse * matrix * inverse - inverse).norm(), 1e-12);
}

}  // namespace
}  // namespace counterpart::numerics
