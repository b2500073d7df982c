// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <numbers>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Vertices on a moment curve: no three on a line, all triangles of positive area.
TriangleMesh abstract_mesh(Index n_vertices, Triangles triangles) {
    TriangleMesh mesh{Points(n_vertices, 3), std::move(triangles)};
    for (Index v = 0; v < n_vertices; ++v) mesh.vertices.row(v) << v, v * v, v * v * v;
    return mesh;
}

TEST(Analyze, ClosedSurfaces) {
    const MeshReport sphere = analyze(make_icosphere(2));
    EXPECT_EQ(sphere.n_vertices, 162);
    EXPECT_EQ(sphere.n_edges, 480);
    EXPECT_EQ(sphere.n_triangles, 320);
    ASSERT_EQ(sphere.components.size(), 1U);
    EXPECT_EQ(sphere.components[0].genus(), 0);
    EXPECT_TRUE(sphere.is_closed() && sphere.is_manifold() && sphere.is_consistently_oriented);
    EXPECT_EQ(sphere.n_isolated_vertices + sphere.n_duplicate_vertices + sphere.n_degenerate_triangles +
                  sphere.n_zero_area_triangles + sphere.n_duplicate_triangles + sphere.n_boundary_loops,
              0);
    EXPECT_EQ(analyze(make_torus(12, 8)).components[0].genus(), 1);
}

TEST(Analyze, MeasuresAgreeWithTheirFunctions) {
    const TriangleMesh mesh = test::moved(make_torus(20, 10), 3);
    const MeshReport report = analyze(mesh);
    EXPECT_DOUBLE_EQ(report.area, surface_area(mesh));
    EXPECT_NEAR(report.mean_edge_length, mean_edge_length(mesh), 1e-12 * report.mean_edge_length);
    EXPECT_EQ(report.n_edges, Adjacency(mesh).n_edges());
    EXPECT_EQ(report.box_min, mesh.vertices.colwise().minCoeff());
    EXPECT_EQ(report.box_max, mesh.vertices.colwise().maxCoeff());
}

TEST(Analyze, BoundariesAndComponents) {
    const MeshReport grid = analyze(make_grid(5, 4));
    EXPECT_EQ(grid.n_boundary_edges, 18);
    EXPECT_EQ(grid.n_boundary_loops, 1);
    EXPECT_EQ(grid.components[0].genus(), 0);
    EXPECT_EQ(grid.components[0].euler_characteristic(), 1);

    TriangleMesh punched = make_torus(12, 8);  // two triangles far apart
    punched.triangles.row(0) = punched.triangles.row(punched.n_triangles() - 1);
    punched.triangles.row(90) = punched.triangles.row(punched.n_triangles() - 2);
    punched.triangles.conservativeResize(punched.n_triangles() - 2, 3);
    const MeshReport two_holes = analyze(punched);
    EXPECT_EQ(two_holes.n_boundary_loops, 2);
    EXPECT_EQ(two_holes.components[0].genus(), 1);

    const MeshReport pieces = analyze(abstract_mesh(8, Triangles{{5, 6, 7}, {1, 2, 3}}));
    ASSERT_EQ(pieces.components.size(), 2U);
    EXPECT_EQ(pieces.n_isolated_vertices, 2);
    EXPECT_EQ(pieces.components[0].n_triangles, 1);
}

TEST(Analyze, LoopsThatTouchAtAVertexAreTwo) {
    const MeshReport report = analyze(abstract_mesh(5, Triangles{{0, 1, 2}, {2, 3, 4}}));
    EXPECT_EQ(report.components.size(), 1U);
    EXPECT_EQ(report.n_nonmanifold_vertices, 1);
    EXPECT_EQ(report.n_nonmanifold_edges, 0);
    EXPECT_EQ(report.n_boundary_loops, 2);
    EXPECT_EQ(report.components[0].genus(), std::nullopt);
}

TEST(Analyze, NonManifoldEdge) {
    const MeshReport report = analyze(abstract_mesh(5, Triangles{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
    EXPECT_EQ(report.n_nonmanifold_edges, 1);
    EXPECT_EQ(report.n_nonmanifold_vertices, 0);
    EXPECT_EQ(report.n_boundary_edges, 6);
    EXPECT_FALSE(report.is_manifold());
    EXPECT_FALSE(report.is_consistently_oriented);
}

TEST(Analyze, OrientationIsNotOrientability) {
    TriangleMesh flipped = make_icosphere(0);
    std::swap(flipped.triangles(4, 0), flipped.triangles(4, 1));
    const MeshReport report = analyze(flipped);
    EXPECT_FALSE(report.is_consistently_oriented);
    EXPECT_TRUE(report.components[0].is_orientable);

    const MeshReport moebius =
        analyze(abstract_mesh(5, Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}}));
    EXPECT_FALSE(moebius.components[0].is_orientable);
    EXPECT_EQ(moebius.components[0].genus(), std::nullopt);
    EXPECT_EQ(moebius.components[0].euler_characteristic(), 0);
    EXPECT_EQ(moebius.n_boundary_loops, 1);
    EXPECT_TRUE(moebius.is_manifold());
}

TEST(Analyze, DegenerateAndDuplicate) {
    TriangleMesh mesh = abstract_mesh(
        7, Triangles{{0, 1, 2}, {2, 0, 1}, {1, 0, 2}, {3, 3, 4}, {5, 5, 5}, {0, 1, 6}, {3, 4, 3}});
    mesh.vertices.row(6) = 0.5 * (mesh.vertices.row(0) + mesh.vertices.row(1));
    mesh.vertices.row(5) = mesh.vertices.row(2);
    const MeshReport report = analyze(mesh);
    EXPECT_EQ(report.n_degenerate_triangles, 3);
    EXPECT_EQ(report.n_zero_area_triangles, 1);
    EXPECT_EQ(report.n_duplicate_triangles, 3);
    EXPECT_EQ(report.n_duplicate_vertices, 1);
    EXPECT_EQ(report.n_isolated_vertices, 3);
    EXPECT_EQ(report.components.size(), 1U);
}

TEST(Analyze, OnlyDegenerateTriangles) {
    const MeshReport report = analyze(abstract_mesh(3, Triangles{{0, 0, 1}}));
    EXPECT_TRUE(report.components.empty());
    EXPECT_EQ(report.n_isolated_vertices, 3);
    EXPECT_EQ(report.mean_edge_length, 0);
}

TEST(Analyze, CountsDoNotDependOnTheOrder) {
    TriangleMesh mesh = make_torus(9, 7);
    mesh.triangles.conservativeResize(mesh.n_triangles() - 5, 3);
    mesh.triangles.row(3) = mesh.triangles.row(40);
    const MeshReport a = analyze(mesh), b = analyze(test::shuffled(mesh, 11).mesh);
    EXPECT_EQ(a.n_edges, b.n_edges);
    EXPECT_EQ(a.n_boundary_edges, b.n_boundary_edges);
    EXPECT_EQ(a.n_boundary_loops, b.n_boundary_loops);
    EXPECT_EQ(a.n_nonmanifold_edges, b.n_nonmanifold_edges);
    EXPECT_EQ(a.n_nonmanifold_vertices, b.n_nonmanifold_vertices);
    EXPECT_EQ(a.n_duplicate_triangles, b.n_duplicate_triangles);
}

TEST(Analyze, RefusesInvalidMeshes) {
    EXPECT_THROW(analyze({}), InvalidInput);
    EXPECT_THROW(analyze(abstract_mesh(2, Triangles{{0, 1, 2}})), InvalidInput);
}

}  // namespace
}  // namespace counterpart
