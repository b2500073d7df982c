// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/multidimensional_scaling.hpp"

#include "base/random.hpp"

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

Matrix distances_among(const Points& points) {
    Matrix distances(points.rows(), points.rows());
    for (Eigen::Index i = 0; i < points.rows(); ++i)
        distances.col(i) = (points.rowwise() - points.row(i)).rowwise().norm();
    return distances;
}

Points random_points(int count) {
    Random random(1);
    Points points(count, 3);
    for (double& x : points.reshaped()) x = random.uniform();
    return points;
}

TEST(MultidimensionalScaling, RestoresDistancesOfPointsInSpace) {
    for (const int count : {1, 2, 3, 40}) {
        const Matrix distances = distances_among(random_points(count));
        const Matrix found = distances_among(multidimensional_scaling(distances));
        EXPECT_LT((found - distances).cwiseAbs().maxCoeff(), 1e-6) << count << " points";
    }
    EXPECT_EQ(multidimensional_scaling(Matrix(0, 0)).rows(), 0);
}

TEST(MultidimensionalScaling, EveryIterationLowersTheStress) {
    // Distances along a ring have no exact embedding.
    constexpr int n = 30;
    Matrix distances(n, n);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) distances(i, j) = std::min(std::abs(i - j), n - std::abs(i - j));
    double last = std::numeric_limits<double>::infinity();
    for (const int iterations : {0, 1, 5, 20, 50}) {
        const double stress =
            (distances_among(multidimensional_scaling(distances, iterations)) - distances).squaredNorm();
        EXPECT_LT(stress, last) << iterations << " iterations";
        last = stress;
    }
}

}  // namespace
}  // namespace counterpart::numerics
