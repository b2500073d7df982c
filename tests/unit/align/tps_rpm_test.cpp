// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/align/tps_rpm.hpp>
#include <counterpart/base/errors.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

// A closed curve, and the same curve smoothly bent.
Matrix curve(Eigen::Index n, Eigen::Index dimension, double bend) {
    Matrix points(n, dimension);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double x = (2 + 0.4 * std::cos(3 * t)) * std::cos(t), y = std::sin(t) + 0.3 * std::cos(2 * t);
        points(i, 0) = x;
        points(i, 1) = y + bend * x * x;
        if (dimension == 3) points(i, 2) = 0.5 * std::sin(2 * t) + bend * y * x;
    }
    return points;
}

Index closest(const Matrix& points, const Eigen::RowVectorXd& query) {
    Eigen::Index best = 0;
    (points.rowwise() - query).rowwise().squaredNorm().minCoeff(&best);
    return static_cast<Index>(best);
}

double share_right(const TpsRpmResult& result, const Matrix& target, const std::vector<Index>& truth) {
    int right = 0;
    for (Eigen::Index i = 0; i < result.transformed.rows(); ++i)
        right += closest(target, result.transformed.row(i)) == truth[static_cast<std::size_t>(i)] ? 1 : 0;
    return right / static_cast<double>(truth.size());
}

TEST(TpsRpm, RefusesBadInput) {
    const Matrix x = curve(10, 3, 0);
    EXPECT_THROW(tps_rpm(Matrix(0, 3), x), InvalidInput);
    EXPECT_THROW(tps_rpm(x, curve(10, 2, 0)), InvalidInput);
    Matrix infinite = x;
    infinite(0, 0) = INFINITY;
    EXPECT_THROW(tps_rpm(infinite, x), InvalidInput);
    for (const double rate : {0.0, 1.0, std::nan("")}) {
        TpsRpmOptions options;
        options.annealing_rate = rate;
        EXPECT_THROW(tps_rpm(x, x, options), InvalidInput);
    }
    TpsRpmOptions options;
    options.bending_weight = 0;
    EXPECT_THROW(tps_rpm(x, x, options), InvalidInput);
    options = {};
    options.iterations_per_temperature = 0;
    EXPECT_THROW(tps_rpm(x, x, options), InvalidInput);
}

TEST(TpsRpm, MatchesABentCurveIn2dAnd3d) {
    for (const Eigen::Index dimension : {2, 3}) {
        const Matrix x = curve(60, dimension, 0), bent = curve(60, dimension, 0.2);
        std::vector<Index> truth(60);
        Matrix y(60, dimension);
        for (Index i = 0; i < 60; ++i)
            y.row(truth[static_cast<std::size_t>(i)] = (i * 7 + 3) % 60) = bent.row(i);
        const TpsRpmResult result = tps_rpm(x, y);
        EXPECT_TRUE(result.converged) << dimension;
        EXPECT_GE(share_right(result, y, truth), 0.95) << dimension;
        // The transform is what moved the points.
        EXPECT_LT((result.transform(x) - result.transformed).norm(), 1e-6);
        EXPECT_EQ(result.soft_assignment.rows(), 60);
    }
}

TEST(TpsRpm, ToleratesPointsWithoutPartner) {
    const Matrix x = curve(50, 2, 0), bent = curve(50, 2, 0.1);
    Matrix y(54, 2);
    y.topRows(50) = bent;
    y.bottomRows(4) << 0.1, 0.2, -0.2, 0.1, 0.3, -0.3, 0, 0;
    std::vector<Index> truth(50);
    for (Index i = 0; i < 50; ++i) truth[static_cast<std::size_t>(i)] = i;
    EXPECT_GE(share_right(tps_rpm(x, y), y, truth), 0.9);
}

TEST(TpsRpm, DoesNotDependOnUnitOrPlace) {
    const Matrix x = curve(40, 2, 0), y = curve(40, 2, 0.15);
    const TpsRpmResult near = tps_rpm(x, y);
    const Matrix far_x = (1000 * x).array() + 5000, far_y = (1000 * y).array() + 5000;
    const TpsRpmResult far = tps_rpm(far_x, far_y);
    EXPECT_LT((((far.transformed.array() - 5000) / 1000).matrix() - near.transformed).cwiseAbs().maxCoeff(),
              1e-3);
    EXPECT_LT((far.transform(far_x) - far.transformed).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_NEAR(far.final_temperature / near.final_temperature, 1e6, 1e3);
}

TEST(TpsRpm, TinyAndCoincidentSets) {
    const Matrix one = Matrix::Constant(1, 3, 1.0), other = Matrix::Constant(1, 3, 4.0);
    EXPECT_LT((tps_rpm(one, other).transformed - other).norm(), 0.1);
    const Matrix same = Matrix::Constant(8, 3, 2.0);
    EXPECT_TRUE(tps_rpm(same, same).transformed.allFinite());
}

TEST(TpsRpm, CanBeStoppedAndSaysWhenItDidNotConverge) {
    TpsRpmOptions options;
    options.progress = [](double) { return false; };
    EXPECT_THROW(tps_rpm(curve(10, 2, 0), curve(10, 2, 0), options), Canceled);
    options = {};
    options.initial_temperature = 10;
    options.final_temperature = 9.9;
    options.iterations_per_temperature = 1;
    EXPECT_FALSE(tps_rpm(curve(30, 2, 0), curve(30, 2, 0.3), options).converged);
}

}  // namespace
}  // namespace counterpart::align
