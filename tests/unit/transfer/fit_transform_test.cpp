// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/disguise.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/transfer/fit_transform.hpp>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

Transform some_motion(double angle, double scale) {
    return {scale * Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -1, 2).normalized()).toRotationMatrix(),
            {0.3, -0.2, 0.1}};
}

TEST(FitTransform, FindsTheMotionThatWasMade) {
    const Points points = make_body({.subdivisions = 0}).vertices;
    for (const auto model : {TransformModel::rigid, TransformModel::similarity, TransformModel::affine}) {
        const Transform truth = some_motion(2.5, model == TransformModel::rigid ? 1 : 1.7);
        const Transform fit = fit_transform(points, truth(points), model);
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
    const Transform fit = fit_transform(from, to, TransformModel::rigid, Vector{{1, 1, 1, 0}});
    EXPECT_LT((fit.linear - Eigen::Matrix3d::Identity()).norm(), 1e-12);
}

TEST(FitTransform, RefusesDegeneratePoints) {
    const Points line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
    const Points plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    EXPECT_THROW(fit_transform(line, line), InvalidInput);
    EXPECT_THROW(fit_transform(plane, plane, TransformModel::affine), InvalidInput);
    EXPECT_NO_THROW(fit_transform(plane, plane));
    EXPECT_THROW(fit_transform(plane.topRows(2), plane.topRows(2)), InvalidInput);
    EXPECT_THROW(fit_transform(plane, plane.topRows(3)), InvalidInput);
    EXPECT_THROW(fit_transform(plane, plane, TransformModel::rigid, Vector::Zero(4)), InvalidInput);
}

TEST(Icp, FindsASmallMotionWithoutPairs) {
    const TriangleMesh target = make_body({.subdivisions = 1});
    const Transform truth = some_motion(0.15, 1);
    TriangleMesh source = target;
    source.vertices = truth(target.vertices);
    Transform start;
    start.translation = -truth.translation;
    const IcpResult result = icp(source, target, start, {}, {.most_iterations = 300});
    EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().mean(), 0.01);
}

TEST(Icp, KnownPairsCarryItOverALargeMotion) {
    const TriangleMesh target = make_body({.subdivisions = 1});
    const Transform truth = some_motion(2.8, 1);
    TriangleMesh source = target;
    source.vertices = truth(target.vertices);
    VertexMap pairs = identity_map(source.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v)
        if (v % 200 != 0) pairs.image[static_cast<std::size_t>(v)] = VertexMap::unmatched;
    const IcpResult result =
        icp(source, target, {}, surface_map_of(pairs, target), {.most_iterations = 500, .known_weight = 10});
    EXPECT_TRUE(result.converged);
    EXPECT_LT((result.target_from_source(source.vertices) - target.vertices).rowwise().norm().maxCoeff(),
              1e-3);
}

TEST(Icp, RefusesBadOptions) {
    const TriangleMesh mesh = make_icosphere(0);
    EXPECT_THROW(icp(mesh, mesh, {}, {}, {.most_iterations = 0}), InvalidInput);
    EXPECT_THROW(icp(mesh, mesh, {}, {}, {.trim = 0.95}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
