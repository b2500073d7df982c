// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/align/fit_surface.hpp>
#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh template_body() { return make_body({.subdivisions = 1}); }

TriangleMesh bent(const TriangleMesh& mesh) {
    DeformOptions options;
    options.bend = 0.5;
    return deform(mesh, options);
}

double diagonal(const TriangleMesh& mesh) {
    return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
}

TEST(FitSurface, RefusesWhatDoesNotFit) {
    const TriangleMesh mesh = template_body();
    const SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), mesh);
    test::expect_error<InvalidInput>([&] { fit_surface(mesh, mesh, map, {.stiffness = 0}); }, "stiffness");
    test::expect_error<InvalidInput>([&] { fit_surface(mesh, mesh, map, {.reach = 0}); }, "reach");
    test::expect_error<InvalidInput>(
        [&] {
            fit_surface(mesh, mesh, map, {.landmarks = {{0, mesh.n_vertices()}}});
        },
        "landmark");
    SurfaceMap empty = map;
    for (SurfacePoint& point : empty.image) point = {};
    test::expect_error<InvalidInput>([&] { fit_surface(mesh, mesh, empty); }, "fewer than three");
    empty.image.pop_back();
    EXPECT_THROW(fit_surface(mesh, mesh, empty), InvalidInput);
}

TEST(FitSurface, LiesOnTheScanWithoutFolds) {
    const TriangleMesh mesh = template_body(), scan = bent(mesh);
    const FitResult fit = fit_surface(mesh, scan, surface_map_of(identity_map(mesh.n_vertices()), scan));
    EXPECT_LT(fit.distance.mean(), 0.003 * diagonal(scan));
    EXPECT_LE(fit.folded_edges, fit.own_folded_edges + 0.003);
    EXPECT_GT(fit.least_area_ratio, 0.01);
}

TEST(FitSurface, FollowsItsSurroundingsWhereTheMapAndTheScanEnd) {
    const TriangleMesh mesh = template_body();
    TriangleMesh scan = bent(mesh);
    SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), scan);
    const double cut = scan.vertices.col(1).maxCoeff() - 0.2 * diagonal(scan);
    std::vector<Index> kept;
    for (Index t = 0; t < scan.n_triangles(); ++t)
        if (scan.vertices(scan.triangles(t, 0), 1) < cut) kept.push_back(t);
    scan.triangles = Triangles(scan.triangles(kept, Eigen::all));
    map = surface_map_of(identity_map(mesh.n_vertices()), scan);
    const FitResult fit = fit_surface(mesh, scan, map);
    EXPECT_GT(fit.n_free, 0);
    EXPECT_GT(fit.least_area_ratio, 0.01);
    // The head is still as tall as it was.
    EXPECT_GT(fit.vertices.col(1).maxCoeff(), cut + 0.1 * diagonal(mesh));
}

TEST(FitSurface, TellsWhatOfTheScanLiesBare) {
    const TriangleMesh mesh = template_body(), scan = bent(mesh);
    const SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), scan);
    EXPECT_LT(fit_surface(mesh, scan, map).scan_distance.maxCoeff(), 0.01 * diagonal(scan));
    // A second body beside it, on which nothing is laid.
    TriangleMesh two = scan;
    const Index n = scan.n_vertices(), f = scan.n_triangles();
    two.vertices.conservativeResize(2 * n, 3);
    two.vertices.bottomRows(n) = scan.vertices.rowwise() + Eigen::RowVector3d(0, 0, 2 * diagonal(scan));
    two.triangles.conservativeResize(2 * f, 3);
    two.triangles.bottomRows(f) = scan.triangles.array() + n;
    const FitResult fit = fit_surface(mesh, two, map);
    ASSERT_EQ(fit.scan_distance.size(), 2 * n);
    EXPECT_LT(fit.scan_distance.head(n).maxCoeff(), 0.01 * diagonal(two));
    EXPECT_GT(fit.scan_distance.tail(n).minCoeff(), diagonal(scan));
}

TEST(FitSurface, NothingCrumplesWhereTheMapIsScrambled) {
    const TriangleMesh mesh = template_body(), scan = bent(mesh);
    Index hand = 0;
    mesh.vertices.col(0).maxCoeff(&hand);
    std::vector<Index> image;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const bool in_hand = (mesh.vertices.row(v) - mesh.vertices.row(hand)).norm() < 0.15 * diagonal(mesh);
        image.push_back(in_hand ? 7919 * v % mesh.n_vertices() : v);
    }
    const FitResult fit = fit_surface(mesh, scan, surface_map_of(VertexMap(image, scan.n_vertices()), scan));
    EXPECT_LT(fit.distance.mean(), 0.003 * diagonal(scan));
    EXPECT_LE(fit.folded_edges, fit.own_folded_edges + 0.003);
    EXPECT_GT(fit.least_area_ratio, 0.01);
}

TEST(FitSurface, LandmarksMeetAndThreadsDoNotMatter) {
    const TriangleMesh mesh = template_body(), scan = bent(mesh);
    const SurfaceMap map = surface_map_of(identity_map(mesh.n_vertices()), scan);
    const FitOptions one{.landmarks = {{10, 10}, {200, 200}}, .n_threads = 1};
    FitOptions two = one;
    two.n_threads = 2;
    const FitResult fit = fit_surface(mesh, scan, map, one);
    for (const auto& [from, to] : one.landmarks)
        EXPECT_LT((fit.vertices.row(from) - scan.vertices.row(to)).norm(), 0.005 * diagonal(scan));
    EXPECT_EQ(fit.vertices, fit_surface(mesh, scan, map, two).vertices);
}

TEST(FitSurface, VerticesOfTheScanInNoTriangleAreNoSurface) {
    const TriangleMesh mesh = make_body({.subdivisions = 0}), scan = bent(mesh);
    TriangleMesh with_stray = scan;
    with_stray.vertices.conservativeResize(scan.n_vertices() + 1, 3);
    with_stray.vertices.bottomRows(1).setConstant(1000);
    const VertexMap map = identity_map(mesh.n_vertices());
    const FitResult expected = fit_surface(mesh, scan, surface_map_of(map, scan)),
                    fit = fit_surface(mesh, with_stray, surface_map_of(map, scan));
    EXPECT_NEAR(fit.scan_diagonal, diagonal(scan), 1e-12);
    EXPECT_EQ(fit.vertices, expected.vertices);
}

}  // namespace
}  // namespace counterpart
