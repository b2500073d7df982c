// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/nearest_neighbors.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/analyze.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <map>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

void expect_closed_and_outward(const TriangleMesh& mesh, Index genus) {
    const MeshReport report = analyze(mesh);
    EXPECT_TRUE(report.is_closed() && report.is_manifold() && report.is_consistently_oriented);
    ASSERT_EQ(report.components.size(), 1U);
    EXPECT_EQ(report.components[0].genus(), genus);
    EXPECT_EQ(report.n_isolated_vertices + report.n_duplicate_vertices, 0);
    EXPECT_GT(signed_volume(mesh), 0);
}

TEST(Shapes, IcosphereIsTheUnitSphere) {
    EXPECT_EQ(make_icosphere(0).n_vertices(), 12);
    const TriangleMesh mesh = make_icosphere(4);
    EXPECT_EQ(mesh.n_vertices(), 10 * 256 + 2);
    expect_closed_and_outward(mesh, 0);
    EXPECT_LT((mesh.vertices.rowwise().norm().array() - 1).abs().maxCoeff(), 1e-15);
    EXPECT_NEAR(surface_area(mesh), 4 * std::numbers::pi, 0.02 * 4 * std::numbers::pi);
    EXPECT_THROW(make_icosphere(-1), InvalidInput);
    EXPECT_THROW(make_icosphere(11), InvalidInput);
}

TEST(Shapes, RefusesMoreTrianglesThanAMeshMayHave) {
    for (const auto& [columns, rows] : {std::pair{50'000, 50'000}, {2'000'000'000, 1}, {1, 2'147'483'647}}) {
        EXPECT_THROW(make_grid(columns, rows), InvalidInput) << columns << " x " << rows;
        EXPECT_THROW(make_torus(std::max(columns, 3), std::max(rows, 3)), InvalidInput) << columns;
    }
}

TEST(Shapes, TorusHasItsAreaAndVolume) {
    const TriangleMesh mesh = make_torus(96, 48);
    expect_closed_and_outward(mesh, 1);
    const double pi2 = std::numbers::pi * std::numbers::pi;
    EXPECT_NEAR(surface_area(mesh), 4 * pi2 * 0.4, 0.01 * 4 * pi2 * 0.4);
    EXPECT_NEAR(signed_volume(mesh), 2 * pi2 * 0.16, 0.01 * 2 * pi2 * 0.16);
    EXPECT_THROW(make_torus(2, 3), InvalidInput);
}

TEST(Shapes, GridIsTheUnitSquareFacingUp) {
    const TriangleMesh mesh = make_grid(4, 3);
    EXPECT_EQ(mesh.n_vertices(), 20);
    EXPECT_NEAR(surface_area(mesh), 1, 1e-15);
    const Points normals = triangle_normals(mesh);
    EXPECT_EQ(normals.col(2).minCoeff(), 1);
    EXPECT_THROW(make_grid(0, 3), InvalidInput);
}

TEST(Shapes, BodyIsClosedAndOutward) {
    for (const bool symmetric : {false, true}) {
        for (const int subdivisions : {0, 1, 3})
            expect_closed_and_outward(make_body({.subdivisions = subdivisions, .symmetric = symmetric}), 0);
    }
    const MeshReport report = analyze(make_body());
    EXPECT_NEAR(report.n_vertices, 4500, 100);
    EXPECT_NEAR(report.box_max.y() - report.box_min.y(), 1, 0.15);
    EXPECT_THROW(make_body({.subdivisions = 8}), InvalidInput);
}

// Color refinement: vertices whose neighborhoods differ get different colors. As many colors as vertices
// means that no renumbering but the identity keeps the connectivity.
std::size_t count_colors(const TriangleMesh& mesh) {
    const Adjacency adjacency(mesh);
    std::vector<Index> color(static_cast<std::size_t>(mesh.n_vertices()), 0);
    for (std::size_t count = 1;;) {
        std::map<std::vector<Index>, Index> names;
        std::vector<std::vector<Index>> keys;
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            std::vector<Index> key;
            for (const Index w : adjacency.neighbors(v)) key.push_back(color[static_cast<std::size_t>(w)]);
            std::sort(key.begin(), key.end());
            key.push_back(color[static_cast<std::size_t>(v)]);
            names.try_emplace(key, 0);
            keys.push_back(std::move(key));
        }
        Index next = 0;
        for (auto& [key, name] : names) name = next++;
        for (std::size_t v = 0; v < keys.size(); ++v) color[v] = names[keys[v]];
        if (names.size() == count) return count;
        count = names.size();
    }
}

TEST(Shapes, BodyHasNoSymmetryUnlessAsked) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    EXPECT_EQ(count_colors(mesh), static_cast<std::size_t>(mesh.n_vertices()));

    const TriangleMesh symmetric = make_body({.subdivisions = 1, .symmetric = true});
    const auto on_plane = (symmetric.vertices.col(0).array().abs() < 1e-12).count();
    EXPECT_EQ(count_colors(symmetric), static_cast<std::size_t>((symmetric.n_vertices() + on_plane) / 2));
}

TEST(Shapes, SymmetricBodyIsItsMirrorImage) {
    const TriangleMesh mesh = make_body({.symmetric = true});
    const numerics::NearestNeighbors neighbors(mesh.vertices);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::RowVector3d mirrored = mesh.vertices.row(v).cwiseProduct(Eigen::RowVector3d(-1, 1, 1));
        EXPECT_LT(neighbors.closest(mirrored).squared_distance, 1e-26) << v;
    }
}

}  // namespace
}  // namespace counterpart
