// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/carry_points.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Points between the corners of every 7th triangle.
Points points_on(const TriangleMesh& mesh) {
    Points points(mesh.n_triangles() / 7, 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        const auto corners = mesh.triangles.row(7 * i);
        points.row(i) = 0.5 * mesh.vertices.row(corners[0]) + 0.3 * mesh.vertices.row(corners[1]) +
                        0.2 * mesh.vertices.row(corners[2]);
    }
    return points;
}

TEST(CarryPoints, FollowTheSurfaceThroughAShuffledBend) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const TriangleMesh bent = deform(source, {.bend = 1.0, .twist = 0.5});
    const ShuffleResult target = shuffle(bent, 3);
    const SurfaceMap map =
        surface_map_of(VertexMap(target.shuffled_from_original, bent.n_vertices()), target.mesh);
    const Points carried = carry_points(points_on(source), source, target.mesh, map);
    EXPECT_LT((carried - points_on(bent)).rowwise().norm().maxCoeff(), 1e-9);
}

TEST(CarryPoints, OffTheSurfaceGoWhereTheClosestPointGoes) {
    const TriangleMesh sphere = make_icosphere(3);
    const SurfaceMap map = surface_map_of(identity_map(sphere.n_vertices()), sphere);
    const Points on = points_on(sphere), off = 1.2 * on;
    const Points carried = carry_points(off, sphere, sphere, map);
    EXPECT_LT((carried - on).rowwise().norm().maxCoeff(), 0.05);
}

TEST(CarryPoints, WithoutAPartnerAreNaN) {
    const TriangleMesh sphere = make_icosphere(2);
    SurfaceMap map = surface_map_of(identity_map(sphere.n_vertices()), sphere);
    for (Index v = 0; v < sphere.n_vertices(); ++v)
        if (sphere.vertices(v, 2) < 0) map.image[static_cast<std::size_t>(v)] = {};
    Points poles(2, 3);
    poles << 0, 0, -1, 0, 0, 1;
    const Points carried = carry_points(poles, sphere, sphere, map);
    EXPECT_TRUE(carried.row(0).hasNaN());
    EXPECT_LT((carried.row(1) - Eigen::RowVector3d(0, 0, 1)).norm(), 0.05);
}

TEST(CarryPoints, RefuseWhatIsNoPoint) {
    const TriangleMesh sphere = make_icosphere(1);
    const SurfaceMap map = surface_map_of(identity_map(sphere.n_vertices()), sphere);
    const Points bad = Points::Constant(1, 3, std::numeric_limits<double>::infinity());
    test::expect_error<InvalidInput>([&] { carry_points(bad, sphere, sphere, map); }, "point 0");
    test::expect_error<InvalidInput>([&] { carry_points(bad, sphere, make_icosphere(2), map); }, "");
}

}  // namespace
}  // namespace counterpart
