// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

Points random_cloud(Eigen::Index n, std::uint64_t seed) {
    Random random(seed);
    return Points::NullaryExpr(n, 3, [&] { return random.uniform(-1, 1); });
}

Similarity small_motion(double scale) {
    Similarity motion;
    motion.rotation = Eigen::AngleAxisd(2.3, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    motion.translation = Eigen::Vector3d(3, -1, 7);
    motion.scale = scale;
    return motion;
}

TEST(Rigid, RefusesWhatCannotBeAligned) {
    EXPECT_THROW(align_centroids(Points(0, 3), random_cloud(3, 1)), InvalidInput);
    EXPECT_THROW(kabsch(random_cloud(3, 1), random_cloud(4, 1)), InvalidInput);
    EXPECT_THROW(kabsch(Points(0, 3), Points(0, 3)), InvalidInput);
    EXPECT_THROW(kabsch(random_cloud(3, 1), random_cloud(3, 1), Vector::Ones(2)), InvalidInput);
    EXPECT_THROW(kabsch(random_cloud(3, 1), random_cloud(3, 1), Vector::Zero(3)), InvalidInput);
    EXPECT_THROW(kabsch(random_cloud(2, 1), random_cloud(2, 1), Eigen::Vector2d(1, -1)), InvalidInput);
}

TEST(Rigid, CentroidsMeet) {
    const Points a = random_cloud(5, 1), b = random_cloud(9, 2);
    EXPECT_LT((align_centroids(a, b)(a).colwise().mean() - b.colwise().mean()).norm(), 1e-14);
}

TEST(Rigid, KabschFindsTheMotion) {
    const Points a = random_cloud(20, 3);
    for (const double scale : {1.0, 2.5}) {
        const Similarity truth = small_motion(scale);
        KabschOptions options;
        options.with_scale = scale != 1;
        const Similarity found = kabsch(a, truth(a), {}, options);
        EXPECT_LT((found.rotation - truth.rotation).norm(), 1e-12);
        EXPECT_LT((found.translation - truth.translation).norm(), 1e-12);
        EXPECT_NEAR(found.scale, scale, 1e-12);
    }
}

TEST(Rigid, WeightsOfZeroHideOutliers) {
    const Points a = random_cloud(12, 4);
    Points b = small_motion(1)(a);
    b.row(3).setConstant(100);
    Vector weights = Vector::Ones(12);
    EXPECT_GT((kabsch(a, b)(a) - b).topRows(3).norm(), 1);
    weights[3] = 0;
    EXPECT_LT((kabsch(a, b, weights)(a) - b).topRows(3).norm(), 1e-12);
}

TEST(Rigid, NeverReflects) {
    const Points a = random_cloud(15, 5);
    Points mirrored = a;
    mirrored.col(1) *= -1;
    const Similarity motion = kabsch(a, mirrored);
    EXPECT_NEAR(motion.rotation.determinant(), 1, 1e-12);
    EXPECT_GT((motion(a) - mirrored).norm(), 0.1);
}

TEST(Rigid, ThePriorDecidesWhatThePointsLeaveOpen) {
    KabschOptions options;
    options.prior_rotation = small_motion(1).rotation;
    options.prior_weight = 1e-3;
    const Points one = random_cloud(1, 6);
    EXPECT_LT((kabsch(one, one, {}, options).rotation - options.prior_rotation).norm(), 1e-12);
    // Many points overrule it.
    const Points many = random_cloud(50, 7);
    EXPECT_LT((kabsch(many, many, {}, options).rotation - Eigen::Matrix3d::Identity()).norm(), 1e-3);
}

}  // namespace
}  // namespace counterpart::align
