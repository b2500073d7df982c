// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/rotation.hpp"

#include "base/random.hpp"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

Eigen::Matrix3d random_matrix(Random& random) {
    return Eigen::Matrix3d::NullaryExpr([&](Eigen::Index, Eigen::Index) { return random.uniform(-1, 1); });
}

Eigen::Quaterniond random_rotation(Random& random) {
    const auto x = [&] { return random.uniform(-1, 1); };
    return Eigen::Quaterniond(x(), x(), x(), x()).normalized();
}

// What a rotation is to make large.
double agreement(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& rotation) {
    return covariance.cwiseProduct(rotation).sum();
}

TEST(FitRotation, IsTheIdentityWhereNumbersAreNotFinite) {
    for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
        covariance(1, 2) = bad;
        const FittedRotation fitted = fit_rotation(covariance);
        EXPECT_EQ(fitted.rotation, Eigen::Matrix3d::Identity());
        EXPECT_EQ(fitted.rank, 0);
    }
}

// A call makes a limited number of steps, which now and then is too few for a start far away.
TEST(FollowRotation, CalledAgainEndsWhereTheDirectFitDoesFromAnyStart) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const Eigen::Matrix3d covariance = random_matrix(random);  // reflections are among them
        const double best = agreement(covariance, fit_rotation(covariance).rotation);
        Eigen::Quaterniond found = random_rotation(random);
        for (int call = 0; call < 3; ++call) found = follow_rotation(covariance, found);
        EXPECT_GT(agreement(covariance, found.toRotationMatrix()), best - 1e-3 * covariance.norm()) << i;
    }
}

TEST(FollowRotation, IsExactFromNearby) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Eigen::Quaterniond rotation = random_rotation(random);
        const Eigen::Matrix3d covariance =
            rotation.toRotationMatrix() * Eigen::Vector3d(3, 2, 1).asDiagonal().toDenseMatrix();
        const Eigen::Quaterniond start =
            Eigen::Quaterniond(1, random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), 0.05).normalized() *
            rotation;
        EXPECT_LT(follow_rotation(covariance, start).angularDistance(rotation), 1e-7) << i;
    }
}

TEST(ShortestRotation, TakesOneDirectionToTheOther) {
    Random random(3);
    const auto direction = [&] { return random_rotation(random) * Eigen::Vector3d::UnitX(); };
    for (int i = 0; i < 200; ++i) {
        const Eigen::Vector3d from = direction();
        for (const Eigen::Vector3d& to : {Eigen::Vector3d(direction()), from, Eigen::Vector3d(-from),
                                          Eigen::Vector3d(-from + 1e-9 * direction())}) {
            const Eigen::Quaterniond turn = shortest_rotation(2 * from, 3 * to);
            EXPECT_LT((turn * from - to.normalized()).norm(), 1e-6) << i;
            EXPECT_NEAR(turn.angularDistance(Eigen::Quaterniond::Identity()),
                        std::atan2(from.cross(to).norm(), from.dot(to)), 1e-6);
        }
    }
}

TEST(FollowRotation, StaysFiniteWhereNothingIsDetermined) {
    const Eigen::Quaterniond start(Eigen::AngleAxisd(1, Eigen::Vector3d::UnitX()));
    EXPECT_LT(follow_rotation(Eigen::Matrix3d::Zero(), start).angularDistance(start), 1e-12);
    const Eigen::Matrix3d rank_1 = Eigen::Vector3d(1, 2, 3) * Eigen::RowVector3d(3, 2, 1);
    EXPECT_TRUE(follow_rotation(rank_1, start).coeffs().allFinite());
}

}  // namespace
}  // namespace counterpart::numerics
