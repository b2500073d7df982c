// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/align/thin_plate_spline.hpp>
#include <counterpart/base/errors.hpp>

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

Matrix control_points(Eigen::Index n, Eigen::Index dimension, std::uint64_t seed) {
    Random random(seed);
    return Matrix::NullaryExpr(n, dimension, [&] { return random.uniform(-1, 1); });
}

// The textbook system [K + lambda I, P; P', 0], solved as a whole.
Matrix textbook_spline(const Matrix& controls, const Matrix& images, double lambda, const Matrix& points) {
    const auto n = controls.rows(), d = controls.cols();
    const auto phi = [&](double r) { return d == 3 ? -r : (r > 0 ? r * r * std::log(r) : 0.0); };
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + d + 1, n + d + 1), right(n + d + 1, d);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            system(i, j) = phi((controls.row(i) - controls.row(j)).norm()) + (i == j ? lambda : 0);
        system(i, n) = system(n, i) = 1;
        system.row(i).tail(d) = controls.row(i);
        system.col(i).tail(d) = controls.row(i).transpose();
    }
    right << images, Matrix::Zero(d + 1, d);
    const Eigen::MatrixXd solution = system.fullPivLu().solve(right);
    Matrix result(points.rows(), d);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        result.row(i) = solution.row(n) + points.row(i) * solution.bottomRows(d);
        for (Eigen::Index j = 0; j < n; ++j)
            result.row(i) += phi((points.row(i) - controls.row(j)).norm()) * solution.row(j);
    }
    return result;
}

TEST(ThinPlateSpline, RefusesBadInput) {
    EXPECT_THROW(ThinPlateSpline(Matrix(0, 3), Matrix(0, 3)), InvalidInput);
    EXPECT_THROW(ThinPlateSpline(control_points(4, 4, 1), control_points(4, 4, 1)), InvalidInput);
    EXPECT_THROW(ThinPlateSpline(control_points(4, 3, 1), control_points(5, 3, 1)), InvalidInput);
    EXPECT_THROW(ThinPlateSpline(control_points(4, 3, 1), control_points(4, 3, 1), -1), InvalidInput);
    Matrix nan = control_points(4, 3, 1);
    nan(2, 1) = std::nan("");
    EXPECT_THROW(ThinPlateSpline(nan, control_points(4, 3, 1)), InvalidInput);
    const ThinPlateSpline spline(control_points(4, 3, 1), control_points(4, 3, 2));
    EXPECT_THROW(spline(control_points(4, 2, 1)), InvalidInput);
}

TEST(ThinPlateSpline, CoincidentControlsNeedRegularization) {
    Matrix controls = control_points(8, 3, 1);
    controls.row(5) = controls.row(2);
    const Matrix images = control_points(8, 3, 2);
    EXPECT_THROW(ThinPlateSpline(controls, images), InvalidInput);
    EXPECT_NO_THROW(ThinPlateSpline(controls, images, 0.1));
}

TEST(ThinPlateSpline, AgreesWithTheTextbookSystem) {
    for (const Eigen::Index dimension : {2, 3}) {
        for (const double lambda : {0.0, 0.3}) {
            const Matrix controls = control_points(25, dimension, 1),
                         images = control_points(25, dimension, 2);
            const Matrix points = control_points(40, dimension, 3);
            const ThinPlateSpline spline(controls, images, lambda);
            EXPECT_LT((spline(points) - textbook_spline(controls, images, lambda, points)).norm(), 1e-8)
                << dimension << "D, lambda " << lambda;
            if (lambda == 0) {
                EXPECT_LT((spline(controls) - images).norm(), 1e-9);
            }
        }
    }
}

TEST(ThinPlateSpline, AffineMapsBendNothing) {
    const Matrix controls = control_points(12, 3, 4);
    Matrix linear(3, 3);
    linear << 1, 0.2, 0, -0.3, 2, 0.1, 0.5, 0, 0.7;
    const Matrix images = (controls * linear).rowwise() + Eigen::RowVector3d(1, 2, 3);
    const ThinPlateSpline spline(controls, images, 0.5);
    EXPECT_LT(spline.weights().norm(), 1e-12);
    EXPECT_LT((spline(controls) - images).norm(), 1e-10);
    const ThinPlateSpline bent(controls, control_points(12, 3, 5));
    EXPECT_GT(bent.weights().norm(), 0.01);
}

TEST(ThinPlateSpline, FlatAndTinySetsWork) {
    Matrix flat = control_points(10, 3, 6);
    flat.col(2).setZero();
    const Matrix images = control_points(10, 3, 7);
    EXPECT_LT((ThinPlateSpline(flat, images)(flat) - images).norm(), 1e-8);
    for (const Eigen::Index n : {1, 2, 3, 4, 5}) {
        const Matrix few = control_points(n, 3, 8), there = control_points(n, 3, 9);
        EXPECT_LT((ThinPlateSpline(few, there)(few) - there).norm(), 1e-8) << n;
    }
    // One control moves everything along with it.
    const Matrix one = control_points(1, 3, 8), elsewhere = one.array() + 2;
    EXPECT_LT((ThinPlateSpline(one, elsewhere)(flat) - Matrix(flat.array() + 2)).norm(), 1e-10);
}

}  // namespace
}  // namespace counterpart::align
