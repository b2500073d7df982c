// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

void expect_places_of(const PartOfMesh& part, const TriangleMesh& whole) {
    ASSERT_EQ(part.whole_from_part.size(), static_cast<std::size_t>(part.mesh.n_vertices()));
    for (Index v = 0; v < part.mesh.n_vertices(); ++v)
        EXPECT_EQ(part.mesh.vertices.row(v),
                  whole.vertices.row(part.whole_from_part[static_cast<std::size_t>(v)]));
}

TEST(PartOfMesh, RefusesBadInput) {
    const TriangleMesh mesh = make_grid(2, 2);
    EXPECT_THROW(part_of(mesh, {1, 0}), InvalidInput);
    EXPECT_THROW(cut_by_plane(mesh, {1, NAN, 0}, 0), InvalidInput);
    EXPECT_THROW(cut_by_plane(mesh, {1, 0, 0}, INFINITY), InvalidInput);
    EXPECT_THROW(cut_holes(mesh, -1, 1, 0), InvalidInput);
    EXPECT_THROW(cut_holes(mesh, 1, -1, 0), InvalidInput);
    EXPECT_THROW(cut_holes(mesh, 1, NAN, 0), InvalidInput);
}

TEST(PartOfMesh, APlaneKeepsWhatItsNormalPointsTo) {
    const TriangleMesh grid = make_grid(4, 4);
    const PartOfMesh half = cut_by_plane(grid, {2, 0, 0}, 0.9);  // x > 0.45
    EXPECT_EQ(half.mesh.n_vertices(), 15);
    EXPECT_NEAR(surface_area(half.mesh), 0.5, 1e-12);
    expect_places_of(half, grid);
    EXPECT_EQ(cut_by_plane(grid, {1, 0, 0}, 5).mesh.n_triangles(), 0);
}

TEST(PartOfMesh, HolesHaveTheirRadius) {
    const TriangleMesh grid = make_grid(40, 40);
    const PartOfMesh rest = cut_holes(grid, 1, 0.2, 3);
    expect_places_of(rest, grid);
    const double in_disc = 40 * 40 * 3.1416 * 0.2 * 0.2, lost = grid.n_vertices() - rest.mesh.n_vertices();
    EXPECT_GT(lost, in_disc / 5);  // a quarter of the disc, at a corner
    EXPECT_LT(lost, in_disc * 1.1);
    EXPECT_EQ(cut_holes(grid, 0, 0.2, 3).mesh.triangles, grid.triangles);
    EXPECT_EQ(cut_holes(grid, 1, 0.2, 3).mesh.vertices, rest.mesh.vertices);
    EXPECT_NE(cut_holes(grid, 1, 0.2, 4).whole_from_part, rest.whole_from_part);
}

}  // namespace
}  // namespace counterpart
