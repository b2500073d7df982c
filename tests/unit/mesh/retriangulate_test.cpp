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
    EXPECT_LT(other.mesh.n_vertices(), 0.8 * mesh.n_vertices());
    EXPECT_NEAR(surface_area(other.mesh) / surface_area(mesh), 1, 0.03);
    EXPECT_EQ(analyze(other.mesh).components.at(0).euler_characteristic(),
              analyze(mesh).components.at(0).euler_characteristic());
    for (Index v = 0; v < other.mesh.n_vertices(); ++v)
        EXPECT_EQ(other.mesh.vertices.row(v),
                  mesh.vertices.row(other.original_from_mesh[static_cast<std::size_t>(v)]));
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

}  // namespace
}  // namespace counterpart
