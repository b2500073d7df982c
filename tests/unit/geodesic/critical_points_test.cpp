// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/critical_points.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::geodesic {
namespace {

// A ball with arms of the given lengths along its vertices 0, 1, 2, ... (corners of an icosahedron). The tip
// of each is that vertex.
TriangleMesh urchin(const std::vector<double>& arms) {
    TriangleMesh mesh = make_icosphere(4);
    const Points directions = mesh.vertices;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        double radius = 1;
        for (Index arm = 0; arm < static_cast<Index>(arms.size()); ++arm) {
            const double angle = std::acos(std::clamp(directions.row(v).dot(directions.row(arm)), -1.0, 1.0));
            radius += arms[static_cast<std::size_t>(arm)] * std::exp(-angle * angle / 0.05);
        }
        mesh.vertices.row(v) *= radius;
    }
    return mesh;
}

CriticalPoints tips(const TriangleMesh& mesh, const CriticalPointOptions& options = {}) {
    return critical_points(mesh, DistanceGraph(mesh), options);
}

TEST(CriticalPoints, RefusesOptionsOutOfRange) {
    const TriangleMesh mesh = make_icosphere(1);
    EXPECT_THROW(tips(mesh, {.n_bases = 3}), InvalidInput);
    EXPECT_THROW(tips(mesh, {.min_prominence = -1}), InvalidInput);
    EXPECT_THROW(tips(mesh, {.min_prominence = std::nan("")}), InvalidInput);
    EXPECT_THROW(critical_points(make_grid(1, 1), DistanceGraph(mesh)), InvalidInput);
}

TEST(CriticalPoints, AreTheTipsLongestArmFirst) {
    const TriangleMesh mesh = urchin({3.0, 1.2, 2.4, 1.8});
    const CriticalPoints found = tips(mesh);
    ASSERT_GE(found.vertices.size(), 4u);
    EXPECT_EQ(std::vector<Index>(found.vertices.begin(), found.vertices.begin() + 4),
              (std::vector<Index>{0, 2, 3, 1}));
    EXPECT_TRUE(std::is_sorted(found.prominence.rbegin(), found.prominence.rend()));
    EXPECT_GT(found.prominence[3], 0.3);
}

TEST(CriticalPoints, FollowTheVerticesWhenRenumberedAndMoved) {
    const TriangleMesh mesh = urchin({3.0, 1.2, 2.4, 1.8});
    const test::DisguisedMesh disguised = test::shuffled(test::moved(mesh, 3), 4);
    const CriticalPoints before = tips(mesh), after = tips(disguised.mesh);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(after.vertices[i], disguised.mesh_from_original[before.vertices[i]]);
}

TEST(CriticalPoints, HigherThresholdDropsTheLeastProminent) {
    const TriangleMesh mesh = urchin({3.0, 0.3, 2.4});
    const CriticalPoints all = tips(mesh, {.min_prominence = 0});
    const CriticalPoints few = tips(mesh, {.min_prominence = 0.3});
    EXPECT_EQ(few.vertices, (std::vector<Index>{0, 2}));
    EXPECT_GT(all.vertices.size(), few.vertices.size());
}

TEST(CriticalPoints, EachComponentHasItsOwn) {
    const TriangleMesh a = urchin({3.0, 1.5}), b = urchin({1.5, 2.5});
    TriangleMesh both{Points(2 * a.n_vertices() + 1, 3), Triangles(2 * a.n_triangles(), 3)};
    both.vertices << a.vertices, b.vertices.rowwise() + Eigen::RowVector3d(20, 0, 0),
        Eigen::RowVector3d(40, 0, 0);
    both.triangles << a.triangles, b.triangles.array() + a.n_vertices();
    const std::vector<Index> found = tips(both, {.n_bases = 100, .min_prominence = 0.2}).vertices;
    for (const Index tip : {0, 1, a.n_vertices(), a.n_vertices() + 1, 2 * a.n_vertices()})
        EXPECT_EQ(std::count(found.begin(), found.end(), tip), 1) << "tip " << tip;
    EXPECT_LE(found.size(), 7u);  // each ball may have one more, opposite to its arms
}

TEST(CriticalPoints, SameForAnyNumberOfThreads) {
    const TriangleMesh mesh = urchin({2.0, 1.5, 1.7});
    const CriticalPoints one = tips(mesh, {.n_threads = 1}), three = tips(mesh, {.n_threads = 3});
    EXPECT_EQ(one.vertices, three.vertices);
    EXPECT_EQ(one.prominence, three.prominence);
    EXPECT_EQ(one.average_distance, three.average_distance);
}

TEST(CriticalPoints, OfTheSmallestMeshes) {
    TriangleMesh triangle{Points(3, 3), Triangles(1, 3)};
    triangle.vertices << 0, 0, 0, 4, 0, 0, 0, 3, 0;
    triangle.triangles << 0, 1, 2;
    EXPECT_FALSE(tips(triangle).vertices.empty());
    triangle.vertices.setZero();
    EXPECT_EQ(tips(triangle).vertices, (std::vector<Index>{0}));
}

}  // namespace
}  // namespace counterpart::geodesic
