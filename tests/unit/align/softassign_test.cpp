// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "align/softassign.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

Matrix random_points(Eigen::Index n, Eigen::Index dimension, std::uint64_t seed) {
    Random random(seed);
    return Matrix::NullaryExpr(n, dimension, [&] { return random.uniform(-1, 1); });
}

// The same in double precision with the full (N + 1) x (M + 1) matrix, normalized in place. N x M.
Matrix softassign_reference(const Matrix& target, const Matrix& transformed, double temperature,
                            const SoftassignOptions& options) {
    const Eigen::Index n = transformed.rows(), m = target.rows();
    const Eigen::RowVectorXd target_center = target.colwise().mean(),
                             source_center = transformed.colwise().mean();
    const auto weight = [](const Eigen::RowVectorXd& difference, double t) {
        return std::exp(-difference.squaredNorm() / (2 * t)) / t;
    };
    Matrix full = Matrix::Zero(n + 1, m + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < m; ++j)
            full(i, j) = weight(transformed.row(i) - target.row(j), temperature);
        full(i, m) = weight(transformed.row(i) - target_center, options.outlier_temperature);
    }
    for (Eigen::Index j = 0; j < m; ++j)
        full(n, j) = weight(target.row(j) - source_center, options.outlier_temperature);
    for (int round = 0; round < options.max_sinkhorn; ++round) {
        for (Eigen::Index i = 0; i < n; ++i) full.row(i) /= std::max(full.row(i).sum(), 1e-300);
        for (Eigen::Index j = 0; j < m; ++j) full.col(j) /= std::max(full.col(j).sum(), 1e-300);
    }
    return full.topLeftCorner(n, m);
}

TEST(Softassign, AgreesWithTheReference) {
    for (const Eigen::Index dimension : {2, 3}) {
        for (const double temperature : {2.0, 0.3, 0.02, 0.001}) {
            const Matrix x = random_points(37, dimension, 1), y = random_points(45, dimension, 2);
            SoftassignOptions options;
            options.outlier_temperature = 4;
            options.tolerance = 0;
            Softassign fast(y, x.rows(), options);
            fast.update(x, temperature);
            const Matrix slow = softassign_reference(y, x, temperature, options);
            EXPECT_LT((fast.matrix() - slow).cwiseAbs().maxCoeff(), 2e-4)
                << dimension << "D at " << temperature;
            const Vector mass = slow.rowwise().sum();
            const Matrix means = fast.means(x);
            for (Eigen::Index i = 0; i < x.rows(); ++i) {
                if (mass[i] < 1e-3) continue;
                EXPECT_LT((means.row(i) - slow.row(i) * y / mass[i]).norm(), 1e-3);
            }
        }
    }
}

TEST(Softassign, RowsAndColumnsSumToAtMostOne) {
    const Matrix x = random_points(20, 3, 1), y = random_points(33, 3, 2);
    Softassign assignment(y, x.rows(), {4, 200, 1e-5});
    assignment.update(x, 0.05);
    const Matrix m = assignment.matrix();
    EXPECT_GE(m.minCoeff(), 0);
    EXPECT_LT(m.rowwise().sum().maxCoeff(), 1 + 1e-3);
    EXPECT_LT(m.colwise().sum().maxCoeff(), 1 + 1e-3);
}

TEST(Softassign, ColdAssignmentIsHardAndOutliersKeepTheirPlace) {
    Matrix y = random_points(10, 3, 3);
    Matrix x = y.colwise().reverse();
    Softassign assignment(y, x.rows(), {4, 10, 0});
    assignment.update(x, 1e-4);
    EXPECT_GT(assignment.hardness(), 0.999);
    EXPECT_LT((assignment.means(x) - x).norm(), 1e-3);
    x.row(4).setConstant(50);
    assignment.update(x, 1e-4);
    EXPECT_EQ(assignment.means(x).row(4), x.row(4));
}

}  // namespace
}  // namespace counterpart::align
