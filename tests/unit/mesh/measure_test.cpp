// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// The unit right triangle, a degenerate one at its hypotenuse, and a vertex of no triangle.
TriangleMesh right_triangle() {
    return {Points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {9, 9, 9}}, Triangles{{0, 1, 2}, {1, 2, 1}}};
}

TEST(Measure, RightTriangle) {
    const TriangleMesh mesh = right_triangle();
    EXPECT_EQ(triangle_areas(mesh), (Vector{{0.5, 0}}));
    EXPECT_EQ(surface_area(mesh), 0.5);
    EXPECT_LT((vertex_areas(mesh) - Vector{{1. / 6, 1. / 6, 1. / 6, 0}}).norm(), 1e-15);
    EXPECT_EQ(triangle_normals(mesh), (Points{{0, 0, 1}, {0, 0, 0}}));
    EXPECT_EQ(vertex_normals(mesh), (Points{{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0}}));
    EXPECT_NEAR(mean_edge_length(mesh), (2 + std::numbers::sqrt2) / 3, 1e-15);
    EXPECT_LT((surface_centroid(mesh) - Eigen::Vector3d(1. / 3, 1. / 3, 0)).norm(), 1e-15);
}

TEST(Measure, SphereNormalsPointOutwards) {
    const TriangleMesh mesh = make_icosphere(3);
    EXPECT_GT(vertex_normals(mesh).cwiseProduct(mesh.vertices).rowwise().sum().minCoeff(), 0.999);
    EXPECT_NEAR(signed_volume(mesh), 4 * std::numbers::pi / 3, 0.02 * 4);
    EXPECT_NEAR(vertex_areas(mesh).sum(), surface_area(mesh), 1e-12);
    EXPECT_LT(surface_centroid(mesh).norm(), 1e-12);
}

TEST(Measure, MotionAndMirror) {
    const TriangleMesh mesh = make_body(), moved = test::moved(mesh, 9);
    const double scale = (moved.vertices.row(0) - moved.vertices.row(1)).norm() /
                         (mesh.vertices.row(0) - mesh.vertices.row(1)).norm();
    EXPECT_NEAR(surface_area(moved), scale * scale * surface_area(mesh), 1e-9);
    EXPECT_NEAR(signed_volume(moved), scale * scale * scale * signed_volume(mesh), 1e-9);
    EXPECT_NEAR(mean_edge_length(moved), scale * mean_edge_length(mesh), 1e-12);
    EXPECT_NEAR(signed_volume(test::mirrored(mesh)), signed_volume(mesh), 1e-12);
}

TEST(Measure, VolumeFarFromTheOrigin) {
    TriangleMesh mesh = make_icosphere(2);
    const double volume = signed_volume(mesh);
    mesh.vertices.rowwise() += Eigen::RowVector3d(1e6, -1e6, 1e6);
    EXPECT_NEAR(signed_volume(mesh), volume, 1e-7);
}

}  // namespace
}  // namespace counterpart
