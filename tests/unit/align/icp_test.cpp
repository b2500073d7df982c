// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edited_map.hpp"

#include <counterpart/align/icp.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <limits>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace counterpart::align {
namespace {

Affine some_motion(double angle, double scale) {
    return {scale * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -1, 2).normalized()).toRotationMatrix(),
            {0.3, -0.2, 0.1}};
}

TEST(FitTransform, FindsTheMotionThatWasMade) {
    const Points points = make_body({.subdivisions = 0}).vertices;
    for (const auto model : {TransformModel::rigid, TransformModel::similarity, TransformModel::affine}) {
        const Affine truth = some_motion(2.5, model == TransformModel::rigid ? 1 : 1.7);
        const Affine fit = fit_transform(points, truth(points), model);
        EXPECT_LT((fit.linear - truth.linear).norm(), 1e-10);
        EXPECT_LT((fit.translation - truth.translation).norm(), 1e-10);
    }
}

TEST(FitTransform, NeverReflects) {
    const Points points = make_body({.subdivisions = 0}).vertices;
    const Points mirrored = points * Eigen::Vector3d(-1, 1, 1).asDiagonal();
    EXPECT_GT(fit_transform(points, mirrored, TransformModel::rigid).linear.determinant(), 0.99);
    EXPECT_GT(fit_transform(points, mirrored, TransformModel::similarity).linear.determinant(), 0);
    EXPECT_THROW(fit_transform(points, mirrored, TransformModel::affine), InvalidInput);
}

TEST(FitTransform, WeightsDecide) {
    const Points from{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    Points to = from;
    to.row(3) << -9, 0, 3;
    const Affine fit = fit_transform(from, to, TransformModel::rigid, Vector{{1, 1, 1, 0}});
    EXPECT_LT((fit.linear - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(FitTransform, RefusesDegeneratePoints) {
    const Points line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const Points plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_THROW(fit_transform(line, line), InvalidInput);
    EXPECT_THROW(fit_transform(plane, plane, TransformModel::affine), InvalidInput);
    EXPECT_NO_THROW(fit_transform(plane, plane));
    EXPECT_THROW(fit_transform(Points(plane.topRows(2)), Points(plane.topRows(2))), InvalidInput);
    EXPECT_THROW(fit_transform(plane, Points(plane.topRows(3))), InvalidInput);
    EXPECT_THROW(fit_transform(plane, plane, TransformModel::rigid, Vector::Zero(4)), InvalidInput);
}

TEST(Icp, FindsASmallMotionWithoutPairs) {
    const TriangleMesh target = make_body({.subdivisions = 1});
    const Affine truth = some_motion(0.15, 1);
    TriangleMesh source = target;
    source.vertices = truth(target.vertices);
    Affine start;
    start.translation = -truth.translation;
    const IcpResult result = icp(source, target, start, {}, {.max_iterations = 300});
    EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().mean(), 0.01);
}

TEST(Icp, KnownPairsCarryItOverALargeMotion) {
    const TriangleMesh target = make_body({.subdivisions = 1});
    const Affine truth = some_motion(2.8, 1);
    TriangleMesh source = target;
    source.vertices = truth(target.vertices);
    const VertexMap pairs = test::edited(identity_map(source.n_vertices()), [](std::vector<Index>& image) {
        for (std::size_t v = 0; v < image.size(); ++v)
            if (v % 200 != 0) image[v] = VertexMap::unmatched;
    });
    const IcpResult result =
        icp(source, target, {}, surface_map_of(pairs, target), {.max_iterations = 500, .known_weight = 10});
    EXPECT_TRUE(result.converged);
    EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().maxCoeff(),
              1e-3);
}

TEST(Icp, ManyVerticesAreSampledFirstAndAllAreUsedAtTheEnd) {
    const TriangleMesh target = make_body({.subdivisions = 4});
    ASSERT_GT(target.n_vertices(), 60'000);
    const Affine truth = some_motion(0.15, 1);
    TriangleMesh source = target;
    source.vertices = truth(target.vertices);
    Affine start;
    start.translation = -truth.translation;
    const IcpResult result = icp(source, target, start);
    EXPECT_TRUE(result.converged);
    EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().maxCoeff(),
              1e-6);
}

TEST(Icp, StopsWhereDistancesNoLongerFall) {
    // A body half as large cannot be moved onto the other.
    const TriangleMesh target = make_body({.subdivisions = 1});
    TriangleMesh source = target;
    source.vertices *= 0.5;
    const IcpResult result = icp(source, target);
    EXPECT_TRUE(result.converged);
    EXPECT_GT(result.rms_distance, 0.01);
}

TEST(Icp, RobustWeightsLeaveOutWhatTheTargetLacks) {
    // Of a body whose upper third is missing in the target; from a small turn.
    const TriangleMesh source = make_body({.subdivisions = 1});
    TriangleMesh target = source;
    std::vector<Index> kept;
    for (Index t = 0; t < source.n_triangles(); ++t)
        if (source.vertices(source.triangles(t, 0), 1) < 0.65) kept.push_back(t);
    target.triangles = Triangles(source.triangles(kept, Eigen::all));
    const Affine start = some_motion(0.1, 1);
    const auto error = [&](const IcpOptions& options) {
        const IcpResult result = icp(source, target, {start.linear, {0, 0, 0}}, {}, options);
        return (result.target_from_source(source.vertices) - source.vertices).rowwise().norm().maxCoeff();
    };
    EXPECT_LT(error({.robust = true}), 1e-3);
    EXPECT_GT(error({}), 1e-2);
}

TEST(Icp, AStartOutOfTheRangeOfNumbersIsRefused) {
    const TriangleMesh mesh = make_icosphere(2);
    for (const double factor :
         {1e308, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        Affine start;
        start.linear *= factor;
        EXPECT_THROW(icp(mesh, mesh, start), InvalidInput) << factor;
    }
}

TEST(IcpFromPrincipalAxes, BringsABodyBackFromAnywhere) {
    const TriangleMesh target = make_body({.subdivisions = 0});
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const TriangleMesh source = move_at_random(target, seed);
        const IcpResult result = icp_from_principal_axes(
            source, target, {.model = TransformModel::similarity, .max_iterations = 30});
        EXPECT_TRUE(result.converged);
        EXPECT_LT(result.rms_distance, 1e-9);
        EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().maxCoeff(),
                  1e-9);
    }
}

TEST(IcpFromPrincipalAxes, RigidKeepsTheSize) {
    const TriangleMesh target = make_body({.subdivisions = 0});
    TriangleMesh source = target;
    source.vertices = some_motion(2.8, 1)(target.vertices);
    const IcpResult back = icp_from_principal_axes(source, target, {.max_iterations = 30});
    EXPECT_LT((back.target_from_source(source.vertices) - target.vertices).rowwise().norm().maxCoeff(), 1e-9);
    source.vertices *= 1.2;
    EXPECT_NEAR(icp_from_principal_axes(source, target, {.max_iterations = 30})
                    .target_from_source.linear.determinant(),
                1, 1e-9);
}

TEST(IcpFromPrincipalAxes, ACoarserCopyComesNearForAnyNumberOfThreads) {
    const TriangleMesh target = make_body({.subdivisions = 1});
    const TriangleMesh source = move_at_random(make_body({.subdivisions = 0}), 5);
    const IcpResult result = icp_from_principal_axes(
        source, target, {.model = TransformModel::similarity, .max_iterations = 30, .n_threads = 2});
    EXPECT_LT(result.rms_distance, 0.02);
    EXPECT_EQ(result.target_from_source(source.vertices),
              icp_from_principal_axes(
                  source, target, {.model = TransformModel::similarity, .max_iterations = 30, .n_threads = 1})
                  .target_from_source(source.vertices));
}

TEST(IcpFromPrincipalAxes, OnALineOnlyTheMeansMove) {
    const TriangleMesh line{Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Triangles{{0, 1, 2}}};
    const TriangleMesh target = make_body({.subdivisions = 0});
    for (const auto model : {TransformModel::rigid, TransformModel::similarity}) {
        const Affine motion = icp_from_principal_axes(line, target, {.model = model}).target_from_source;
        EXPECT_EQ(motion.linear, Eigen::Matrix3d::Identity());
        const Eigen::RowVector3d mean = motion(line.vertices).colwise().mean();
        EXPECT_LT((mean - target.vertices.colwise().mean()).norm(), 1e-12);
    }
}

TEST(IcpFromPrincipalAxes, ReportsOneProgressOverAllStarts) {
    const TriangleMesh target = make_body({.subdivisions = 0}), source = move_at_random(target, 2);
    std::vector<double> fractions;
    const auto note = [&](double fraction) {
        fractions.push_back(fraction);
        return true;
    };
    icp_from_principal_axes(source, target, {.max_iterations = 3, .progress = note});
    ASSERT_GE(fractions.size(), 24U);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_GE(fractions.front(), 0);
    EXPECT_EQ(fractions.back(), 1);
    const auto stop = [](double fraction) { return fraction < 0.5; };
    EXPECT_THROW(icp_from_principal_axes(source, target, {.max_iterations = 3, .progress = stop}), Canceled);
}

TEST(Icp, RefusesBadOptions) {
    const TriangleMesh mesh = make_icosphere(0);
    EXPECT_THROW(icp(mesh, mesh, {}, {}, {.max_iterations = 0}), InvalidInput);
    EXPECT_THROW(icp(mesh, mesh, {}, {}, {.trim = 0.95}), InvalidInput);
    EXPECT_THROW(icp_from_principal_axes(mesh, mesh, {.max_iterations = 0}), InvalidInput);
    EXPECT_THROW(icp_from_principal_axes(mesh, mesh, {.trim = 0.95}), InvalidInput);
    EXPECT_THROW(icp_from_principal_axes({}, mesh), InvalidInput);
}

}  // namespace
}  // namespace counterpart::align
