// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Retriangulate, RefusesBadInput) {
    const TriangleMesh mesh = make_icosphere(1);
    EXPECT_THROW(retriangulate(mesh, {.kept_share = 0}), InvalidInput);
    EXPECT_THROW(retriangulate(mesh, {.kept_share = 1.1}), InvalidInput);
    EXPECT_THROW(retriangulate(mesh, {.kept_share = NAN}), InvalidInput);
    EXPECT_THROW(retriangulate(mesh, {.flip_share = -1}), InvalidInput);
    EXPECT_THROW(retriangulate(mesh, {.flip_share = 2}), InvalidInput);
}

TEST(Retriangulate, IsTheSameSurfaceInOtherTriangles) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    const RetriangulateResult other = retriangulate(mesh);
    EXPECT_GE(other.mesh.n_vertices(), 0.7 * mesh.n_vertices());
    EXPECT_LT(other.mesh.n_vertices(), 0.701 * mesh.n_vertices());  // no vertex stays without a reason
    EXPECT_NEAR(surface_area(other.mesh) / surface_area(mesh), 1, 0.03);
    EXPECT_EQ(analyze(other.mesh).components.at(0).euler_characteristic(),
              analyze(mesh).components.at(0).euler_characteristic());
    for (Index v = 0; v < other.mesh.n_vertices(); ++v)
        EXPECT_EQ(other.mesh.vertices.row(v),
                  mesh.vertices.row(other.original_from_mesh[static_cast<std::size_t>(v)]));
    const RetriangulateResult coarse = retriangulate(mesh, {.kept_share = 0.2});
    EXPECT_TRUE(analyze(coarse.mesh).is_closed());
    EXPECT_EQ(analyze(coarse.mesh).components.at(0).euler_characteristic(), 2);
    EXPECT_EQ(retriangulate(mesh).mesh.triangles, other.mesh.triangles);
    EXPECT_NE(retriangulate(mesh, {.seed = 2}).original_from_mesh, other.original_from_mesh);
}

TEST(Retriangulate, LeavesNothingForConnectivity) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    EXPECT_GT(find_differences(mesh, mesh).source_share, 0.99);
    EXPECT_LT(find_differences(retriangulate(mesh).mesh, mesh).source_share, 0.05);
}

TEST(Retriangulate, KeepsBoundariesAndWhatItIsToldToKeep) {
    const TriangleMesh grid = make_grid(8, 8);
    const RetriangulateResult same = retriangulate(grid, {.kept_share = 1, .flip_share = 0});
    EXPECT_EQ(same.mesh.triangles, grid.triangles);
    const RetriangulateResult flipped = retriangulate(grid, {.kept_share = 1});
    EXPECT_EQ(flipped.mesh.vertices, grid.vertices);
    EXPECT_NE(flipped.mesh.triangles, grid.triangles);
    EXPECT_NEAR(surface_area(flipped.mesh), 1, 1e-12);
    const RetriangulateResult few = retriangulate(grid, {.kept_share = 0.05});
    EXPECT_GE(few.mesh.n_vertices(), 32);  // those of the boundary
    EXPECT_NEAR(surface_area(few.mesh), 1, 1e-12);
}

// Rim and hub of a cone with more triangles at its tip than are looked at for each change; what is below its
// rim changes as everywhere.
TEST(Retriangulate, LeavesCrowdedVerticesAlone) {
    constexpr Index n = 400;
    TriangleMesh cone;
    cone.vertices.resize(3 * n + 1, 3);
    cone.triangles.resize(5 * n, 3);
    for (Index i = 0; i < n; ++i) {
        const double angle = 2 * M_PI * i / n;
        for (int ring = 0; ring < 3; ++ring)
            cone.vertices.row(ring * n + i) << std::cos(angle), std::sin(angle), -0.0236 * ring;
        const Index next = (i + 1) % n;
        cone.triangles.row(i) << 3 * n, i, next;
        for (int ring = 0; ring < 2; ++ring) {
            cone.triangles.row((2 * ring + 1) * n + i) << ring * n + i, (ring + 1) * n + i, ring * n + next;
            cone.triangles.row((2 * ring + 2) * n + i) << ring * n + next, (ring + 1) * n + i,
                (ring + 1) * n + next;
        }
    }
    cone.vertices.row(3 * n) << 0, 0, 1;
    const RetriangulateResult other = retriangulate(cone, {.kept_share = 0.5});
    EXPECT_EQ(other.mesh.triangles.topRows(n).col(1), cone.triangles.topRows(n).col(1));
    EXPECT_LT(other.mesh.n_vertices(), cone.n_vertices() - n / 10);
}

TEST(Retriangulate, VerticesInNoTriangleDoNotCount) {
    const TriangleMesh mesh = make_icosphere(3);
    TriangleMesh with_strays = mesh;
    with_strays.vertices.conservativeResize(3 * mesh.n_vertices(), 3);
    with_strays.vertices.bottomRows(2 * mesh.n_vertices()).setConstant(9);
    const RetriangulateResult expected = retriangulate(mesh), found = retriangulate(with_strays);
    EXPECT_EQ(found.original_from_mesh, expected.original_from_mesh);
    EXPECT_EQ(found.mesh.triangles, expected.mesh.triangles);
}

}  // namespace
}  // namespace counterpart
