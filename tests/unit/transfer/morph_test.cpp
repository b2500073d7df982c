// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/transfer/morph.hpp>

#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart {
namespace {

Points turned(const Points& points, double angle) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, -1).normalized()).toRotationMatrix();
    return points * turn.transpose();
}

// A box-like torus piece whose right half is bent by an angle: a strong local rotation.
TriangleMesh bent_body(double degrees) {
    return deform(make_body({.subdivisions = 1}), {.bend = degrees * std::numbers::pi / 180});
}

TEST(Morph, KeyFramesAreExact) {
    const TriangleMesh first = bent_body(0);
    const Points last = bent_body(60).vertices;
    const Morph morph(first, last);
    EXPECT_EQ(morph.at(0), first.vertices);
    EXPECT_EQ(morph.at(1), last);
}

TEST(Morph, RigidMotionStaysRigid) {
    const TriangleMesh first = bent_body(0);
    const Points last = turned(first.vertices, 2.8).rowwise() + Eigen::RowVector3d(3, 0, 1);
    const Points middle = Morph(first, last).at(0.25);
    const Eigen::RowVector3d mean = first.vertices.colwise().mean();
    const Points wanted = turned(first.vertices.rowwise() - mean, 0.7).rowwise() +
                          (0.75 * mean + 0.25 * Eigen::RowVector3d(last.colwise().mean()));
    EXPECT_LT((middle - wanted).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Morph, BendKeepsLengthsAndVolumeWhereLinearBlendingDoesNot) {
    const TriangleMesh first = bent_body(0);
    const Points last = bent_body(150).vertices;
    const std::vector<Points> frames = morph_frames(first, last, 3);
    ASSERT_EQ(frames.size(), 3U);
    const MorphQuality rigid = measure_morph(first, last, 0.5, frames[1], frames[0]);
    const MorphQuality linear =
        measure_morph(first, last, 0.5, Points(0.5 * (first.vertices + last)), frames[0]);
    EXPECT_LT(rigid.mean_edge_error, 0.02);
    EXPECT_GT(rigid.volume_ratio, 0.97);
    EXPECT_EQ(rigid.inverted_triangles, 0);
    EXPECT_GT(linear.mean_edge_error, 2 * rigid.mean_edge_error);
}

TEST(Morph, BackwardsIsTheSameFilm) {
    const TriangleMesh first = bent_body(0), last = bent_body(80);
    const Points there = Morph(first, last.vertices).at(0.3);
    const Points back = Morph(last, first.vertices).at(0.7);
    EXPECT_LT((there - back).cwiseAbs().maxCoeff(), 0.01);
}

TEST(Morph, UniformScalingInterpolatesLengths) {
    const TriangleMesh first = make_icosphere(2);
    const Points middle = Morph(first, Points(3 * first.vertices)).at(0.5);
    EXPECT_LT((middle - 2 * first.vertices).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(Morph, SeparateComponentsAndLoneVerticesTravelTogether) {
    const TriangleMesh ball = make_icosphere(1);
    TriangleMesh pair{Points(2 * ball.n_vertices() + 1, 3), Triangles(2 * ball.n_triangles(), 3)};
    pair.vertices.topRows(ball.n_vertices()) = ball.vertices;
    pair.vertices.middleRows(ball.n_vertices(), ball.n_vertices()) =
        (0.2 * ball.vertices).rowwise() + Eigen::RowVector3d(1.5, 0, 0);
    pair.vertices.bottomRows(1) << -1.2, 0, 0;
    pair.triangles.topRows(ball.n_triangles()) = ball.triangles;
    pair.triangles.bottomRows(ball.n_triangles()) = ball.triangles.array() + ball.n_vertices();
    const Points middle = Morph(pair, turned(pair.vertices, 2)).at(0.5);
    const Eigen::RowVector3d mean = pair.vertices.colwise().mean();
    const Points expected = turned(pair.vertices.rowwise() - mean, 1);
    EXPECT_LT(((middle.rowwise() - middle.colwise().mean()) - expected).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Morph, SameBytesForAnyNumberOfThreads) {
    const TriangleMesh first = bent_body(0);
    const Points last = bent_body(100).vertices;
    EXPECT_EQ(Morph(first, last, {.n_threads = 1}).at(0.4), Morph(first, last, {.n_threads = 3}).at(0.4));
}

TEST(Morph, RefusesWhatItCannotUse) {
    const TriangleMesh mesh = make_icosphere(0);
    EXPECT_THROW(Morph(mesh, make_icosphere(1).vertices), InvalidInput);
    Points bad = mesh.vertices;
    bad(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(Morph(mesh, bad), InvalidInput);
    EXPECT_THROW(Morph(mesh, mesh.vertices, {.iterations = -1}), InvalidInput);
    EXPECT_THROW(Morph(mesh, mesh.vertices).at(1.5), InvalidInput);
    EXPECT_THROW(morph_frames(mesh, mesh.vertices, -1), InvalidInput);
}

TEST(LastPose, UnmatchedVerticesFollowTheWhole) {
    const TriangleMesh first = make_body({.subdivisions = 1});
    TriangleMesh last = first;
    last.vertices = (2 * turned(first.vertices, 1.2)).rowwise() + Eigen::RowVector3d(1, -2, 3);
    SurfaceMap map = surface_map_of(identity_map(first.n_vertices()), last);
    for (Index v = 0; v < first.n_vertices(); v += 3) map.image[static_cast<std::size_t>(v)] = {};
    const LastPose pose = last_pose(first, last, map);
    EXPECT_EQ(pose.n_followers, (first.n_vertices() + 2) / 3);
    EXPECT_LT((pose.vertices - last.vertices).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(LastPose, RefusesAComponentWithoutAnyMatch) {
    const TriangleMesh body = make_body({.subdivisions = 0});
    TriangleMesh two{Points(2 * body.n_vertices(), 3), Triangles(2 * body.n_triangles(), 3)};
    two.vertices << body.vertices, body.vertices.rowwise() + Eigen::RowVector3d(5, 0, 0);
    two.triangles << body.triangles, body.triangles.array() + body.n_vertices();
    SurfaceMap map = surface_map_of(identity_map(two.n_vertices()), two);
    for (Index v = body.n_vertices(); v < two.n_vertices(); ++v) map.image[static_cast<std::size_t>(v)] = {};
    EXPECT_THROW(last_pose(two, two, map), InvalidInput);
}

}  // namespace
}  // namespace counterpart
