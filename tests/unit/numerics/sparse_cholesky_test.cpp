// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/sparse_cholesky.hpp"

#include "base/random.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

// Each unknown is tied to three at random; positive definite by `diagonal` > 0, and singular without it.
SparseMatrix random_laplacian(Eigen::Index n, std::uint64_t seed, double diagonal) {
    Random random(seed);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < n; ++i) {
        entries.emplace_back(i, i, diagonal);
        for (int k = 0; k < 3; ++k) {
            const auto j = static_cast<Eigen::Index>(random.uniform(0, static_cast<double>(n)));
            const double weight = random.uniform(0.1, 1);
            entries.emplace_back(i, j, -weight);
            entries.emplace_back(j, i, -weight);
            entries.emplace_back(i, i, weight);
            entries.emplace_back(j, j, weight);
        }
    }
    SparseMatrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

Eigen::MatrixXd random_columns(Eigen::Index n, Eigen::Index count) {
    Random random(5);
    return Eigen::MatrixXd::NullaryExpr(n, count, [&] { return random.uniform(-1, 1); });
}

SparseCholesky factor_of(const SparseMatrix& matrix) {
    SparseCholesky factor(matrix);
    EXPECT_TRUE(factor.factorize(matrix));
    return factor;
}

TEST(SparseCholesky, SolvesForAnyNumberOfColumns) {
    const SparseMatrix matrix = random_laplacian(80, 1, 0.1);
    const SparseCholesky factor = factor_of(matrix);
    for (const Eigen::Index count : {1, 2, 3, 4, 5, 8, 9, 20}) {
        const Eigen::MatrixXd right = random_columns(80, count);
        EXPECT_LT((matrix * factor.solve(right) - right).norm(), 1e-10) << count;
    }
}

TEST(SparseCholesky, AColumnHasTheSameBitsAloneAndBesideOthers) {
    const SparseCholesky factor = factor_of(random_laplacian(80, 1, 0.1));
    const Eigen::MatrixXd right = random_columns(80, 11), all = factor.solve(right);
    for (Eigen::Index c = 0; c < right.cols(); ++c)
        EXPECT_EQ(all.col(c), factor.solve(Vector(right.col(c)))) << c;
    EXPECT_EQ(Eigen::MatrixXd(factor.solve(Points(right.leftCols(3)))), all.leftCols(3));
}

TEST(SparseCholesky, OneOrderServesAllMatricesOfAPattern) {
    const SparseMatrix matrix = random_laplacian(80, 1, 0.1);
    const Eigen::MatrixXd right = random_columns(80, 3);
    SparseCholesky factor = factor_of(matrix);
    SparseMatrix other = matrix;
    for (Eigen::Index i = 0; i < other.rows(); ++i) other.coeffRef(i, i) += static_cast<double>(i);
    ASSERT_TRUE(factor.factorize(other));
    EXPECT_EQ(factor.solve(right), factor_of(other).solve(right));
}

TEST(SparseCholesky, TheFactorIsTheMatrixInItsOrder) {
    const SparseMatrix matrix = random_laplacian(40, 2, 0.1);
    const SparseCholesky factor = factor_of(matrix);
    const Eigen::MatrixXd lower = Eigen::MatrixXd(factor.lower()) + Eigen::MatrixXd::Identity(40, 40);
    const Eigen::MatrixXd product = lower * factor.diagonal().asDiagonal() * lower.transpose();
    for (Eigen::Index i = 0; i < 40; ++i)
        for (Eigen::Index j = 0; j < 40; ++j)
            EXPECT_NEAR(product(factor.order()[i], factor.order()[j]), matrix.coeff(i, j), 1e-12);
}

TEST(SparseCholesky, ShiftedBelowOneEigenvalueThereIsOneNegativeEntry) {
    // Of a connected Laplacian 0 is the smallest eigenvalue; the others are larger than the shift.
    const SparseCholesky factor = factor_of(random_laplacian(80, 1, -1e-3));
    EXPECT_EQ((factor.diagonal().array() < 0).count(), 1);
}

TEST(SparseCholesky, SaysWhereAPivotIsZero) {
    SparseMatrix matrix(3, 3);
    matrix.insert(0, 0) = 1;
    matrix.insert(1, 1) = 0;
    matrix.insert(2, 2) = 1;
    SparseCholesky factor(matrix);
    EXPECT_FALSE(factor.factorize(matrix));
    matrix.coeffRef(1, 1) = 2;
    EXPECT_TRUE(factor.factorize(matrix));
    EXPECT_EQ(factor.solve(Vector(Vector::Ones(3))), Vector(Eigen::Vector3d(1, 0.5, 1)));
}

}  // namespace
}  // namespace counterpart::numerics
