// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edits.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh two_balls(double gap) {
    const TriangleMesh ball = make_icosphere(3);
    TriangleMesh other = ball;
    other.vertices.rowwise() += Eigen::RowVector3d(2 + gap, 0, 0);
    return test::joined(ball, other);
}

void expect_closed_manifold(const TriangleMesh& mesh) {
    const MeshReport found = analyze(mesh);
    EXPECT_TRUE(found.is_closed());
    EXPECT_TRUE(found.is_manifold());
    EXPECT_TRUE(found.is_consistently_oriented);
    EXPECT_GT(signed_volume(mesh), 0);
}

TEST(Fuse, RefusesBadInput) {
    const TriangleMesh ball = make_icosphere(1);
    for (const double cell : {0.0, -1.0, std::nan(""), HUGE_VAL})
        EXPECT_THROW(fuse(ball, cell), InvalidInput);
    EXPECT_THROW(fuse(ball, 1e-3), InvalidInput);  // 10^10 cells
    EXPECT_THROW(fuse(ball, 50), UnsuitableMesh);
    EXPECT_THROW(fuse(make_grid(3, 3), 0.1), UnsuitableMesh);
}

TEST(Fuse, KeepsASurfaceThatTouchesNothing) {
    const TriangleMesh ball = make_icosphere(3);
    const FusedMesh fused = fuse(ball, 0.1);
    expect_closed_manifold(fused.mesh);
    EXPECT_NEAR(surface_area(fused.mesh) / surface_area(ball), 1, 0.05);
    ASSERT_EQ(fused.fused_from_original.size(), static_cast<std::size_t>(ball.n_vertices()));
    for (Index v = 0; v < ball.n_vertices(); ++v) {
        const Index image = fused.fused_from_original[static_cast<std::size_t>(v)];
        ASSERT_GE(image, 0);
        EXPECT_LT((fused.mesh.vertices.row(image) - ball.vertices.row(v)).norm(), 0.1);
    }
}

TEST(Fuse, JoinsWhatIsNearerThanACell) {
    const TriangleMesh near = two_balls(0.08), far = two_balls(0.5);
    EXPECT_EQ(analyze(fuse(far, 0.1).mesh).components.size(), 2U);
    const FusedMesh fused = fuse(near, 0.1);
    expect_closed_manifold(fused.mesh);
    EXPECT_EQ(analyze(fused.mesh).components.size(), 1U);
    // What touches vanished inside; the far sides did not.
    Index pole = 0, back = 0;
    near.vertices.col(0).head(near.n_vertices() / 2).maxCoeff(&pole);
    near.vertices.col(0).minCoeff(&back);
    EXPECT_EQ(fused.fused_from_original[static_cast<std::size_t>(pole)], -1);
    EXPECT_GE(fused.fused_from_original[static_cast<std::size_t>(back)], 0);
}

TEST(Fuse, IsAManifoldWhereCubesWouldTouchInEdgesAndCorners) {
    for (const double cell : {0.013, 0.021, 0.034})
        expect_closed_manifold(fuse(make_body({.subdivisions = 0}), cell).mesh);
}

}  // namespace
}  // namespace counterpart
