// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edits.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// A bumpy sphere: regular connectivity with many symmetries, positions with none.
TriangleMesh uneven_sphere(int subdivisions, double bend = 0) {
    TriangleMesh mesh = make_icosphere(subdivisions);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const double x = mesh.vertices(v, 0), y = mesh.vertices(v, 1), z = mesh.vertices(v, 2);
        mesh.vertices.row(v) *= 1 + 0.3 * x + 0.2 * std::sin(3 * y + 1) + 0.25 * z * x;
        mesh.vertices(v, 2) *= 1.5;
        mesh.vertices(v, 0) += bend * z * z;
    }
    return mesh;
}

// A square with irregular connectivity: random cells have the other diagonal.
TriangleMesh irregular_grid(int columns, int rows, std::uint64_t pattern) {
    TriangleMesh mesh = make_grid(columns, rows);
    for (Index t = 0; t < mesh.n_triangles(); t += 2) {
        pattern = pattern * 6364136223846793005ULL + 1442695040888963407ULL;
        if ((pattern >> 60) % 2 == 0) continue;
        const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2),
                    d = mesh.triangles(t + 1, 2);
        mesh.triangles.row(t) << a, b, d;
        mesh.triangles.row(t + 1) << b, c, d;
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        mesh.vertices(v, 2) = 0.3 * std::sin(4 * mesh.vertices(v, 0)) * mesh.vertices(v, 1);
    return mesh;
}

double share_right(const VertexMap& map, const VertexMap& truth) {
    int right = 0;
    for (Index v = 0; v < map.source_size(); ++v) right += map[v] == truth[v] ? 1 : 0;
    return static_cast<double>(right) / map.source_size();
}

std::string refusal(const TriangleMesh& source, const TriangleMesh& target,
                    const FrontiersOptions& options = {}) {
    try {
        match_frontiers(source, target, options);
    } catch (const InvalidInput& error) {
        return error.what();
    }
    return "accepted";
}

TEST(MatchFrontiers, NamesTheFirstDifferenceOfConnectivity) {
    const TriangleMesh grid = irregular_grid(10, 8, 1);
    EXPECT_NE(refusal(grid, irregular_grid(10, 9, 1)).find("99 vertices, the target 110"), std::string::npos);
    TriangleMesh fewer = grid;
    fewer.triangles.conservativeResize(grid.n_triangles() - 1, 3);
    EXPECT_NE(refusal(grid, fewer).find("160 triangles, the target 159"), std::string::npos);
    EXPECT_NE(refusal(grid, irregular_grid(10, 8, 2)).find("neighbors"), std::string::npos);
    // The same valences in another arrangement: two components against one.
    EXPECT_NE(refusal(make_torus(18, 9), make_torus(27, 6)).find("level"), std::string::npos);
}

TEST(MatchFrontiers, RefusesBadSourcesAndNamesTheLevel) {
    const TriangleMesh grid = irregular_grid(10, 8, 1);
    FrontiersOptions options;
    options.source_seed = 3;
    EXPECT_NE(refusal(grid, grid, options).find("both"), std::string::npos);
    options.target_seed = 99;
    EXPECT_NE(refusal(grid, grid, options).find("does not exist"), std::string::npos);
    options.target_seed = -2;
    EXPECT_NE(refusal(grid, grid, options).find("does not exist"), std::string::npos);
    options.target_seed = 50;
    EXPECT_NE(refusal(grid, grid, options).find("level 1"), std::string::npos);
    options = {};
    options.deformation_threshold = -1;
    EXPECT_NE(refusal(grid, grid, options), "accepted");
    EXPECT_NE(refusal({Points(0, 3), Triangles(0, 3)}, grid), "accepted");
}

TEST(MatchFrontiers, IrregularConnectivityDecidesAlone) {
    const TriangleMesh source = irregular_grid(30, 20, 1);
    const auto target = test::shuffled(test::moved(source, 5), 6);
    const FrontiersResult result = match_frontiers(source, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.n_decided_by_position, 0);
    EXPECT_EQ(result.confidence.minCoeff(), 1);
    ASSERT_EQ(result.components.size(), 1U);
    EXPECT_EQ(result.components[0].n_alike, 1);
    EXPECT_EQ(result.components[0].target, target.mesh_from_original[result.components[0].source]);
}

TEST(MatchFrontiers, PositionsDecideWhereConnectivityIsSymmetric) {
    const TriangleMesh source = uneven_sphere(3);
    const auto target = test::shuffled(test::moved(uneven_sphere(3, 0.1), 5), 6);
    const FrontiersResult result = match_frontiers(source, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_GT(result.n_decided_by_position, 0);
    EXPECT_EQ(result.components[0].test, SeedTest::ambiguous);
}

TEST(MatchFrontiers, PositionsOnly) {
    const TriangleMesh source = irregular_grid(30, 20, 3);
    const auto target = test::shuffled(test::moved(source, 5), 6);
    FrontiersOptions options;
    options.vertex_hashes = false;
    EXPECT_EQ(match_frontiers(source, target.mesh, options).target_from_source, target.mesh_from_original);
}

TEST(MatchFrontiers, AsPublishedMatchesCloseFrames) {
    const TriangleMesh source = irregular_grid(30, 20, 3);
    TriangleMesh next = source;
    next.vertices.col(2) += 0.1 * source.vertices.col(0).cwiseAbs2();
    const auto target = test::shuffled(next, 6);
    FrontiersOptions options;
    options.paper = true;
    options.pairing = Pairing::closest;
    const FrontiersResult result = match_frontiers(source, target.mesh, options);
    EXPECT_GT(share_right(result.target_from_source, target.mesh_from_original), 0.95);
}

TEST(MatchFrontiers, PairingsAndMetrics) {
    const TriangleMesh source = irregular_grid(16, 12, 3);
    const auto target = test::shuffled(source, 6);
    for (const Pairing pairing : {Pairing::closest, Pairing::mutual, Pairing::optimal}) {
        for (const bool paper : {false, true}) {
            FrontiersOptions options;
            options.pairing = pairing;
            options.paper = paper;
            options.vertex_hashes = false;
            EXPECT_EQ(match_frontiers(source, target.mesh, options).target_from_source,
                      target.mesh_from_original);
        }
    }
    // A metric that prefers the true partner's number is followed, wherever the points are.
    FrontiersOptions options;
    options.paper = true;
    options.deformation_threshold = 1e9;
    options.metric = [&](Index s, Index t, const Eigen::RowVector3d&, const Eigen::RowVector3d&) {
        return target.mesh_from_original[s] == t ? 0.0 : 1.0;
    };
    TriangleMesh scrambled = target.mesh;
    scrambled.vertices = Points::Random(scrambled.n_vertices(), 3);
    EXPECT_EQ(match_frontiers(source, scrambled, options).target_from_source, target.mesh_from_original);
}

TEST(MatchFrontiers, EdgeSplitsDropTheirNewVertices) {
    const TriangleMesh source = uneven_sphere(2);
    const auto target = test::shuffled(source, 6);
    FrontiersOptions options;
    options.edge_splits = true;
    const FrontiersResult result = match_frontiers(source, target.mesh, options);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_GE(result.components[0].n_frontiers * result.components[0].n_frontiers, source.n_vertices());
}

// `parts` side by side.
TriangleMesh joined(const std::vector<TriangleMesh>& parts) {
    TriangleMesh all;
    for (const TriangleMesh& part : parts) all = test::joined(all, part);
    return all;
}

TEST(MatchFrontiers, ComponentsAlikeAreToldApartByPosition) {
    std::vector<TriangleMesh> parts{irregular_grid(20, 12, 1)};
    for (int i = 0; i < 5; ++i) {
        TriangleMesh piece = uneven_sphere(1);
        piece.vertices *= 0.05;
        piece.vertices.rowwise() += Eigen::RowVector3d(0.2 * i, 0.1 * (i % 2), 0.3);
        parts.push_back(piece);
    }
    TriangleMesh point{Points::Constant(1, 3, 0.7), Triangles(0, 3)};
    parts.push_back(point);
    const TriangleMesh source = joined(parts);
    const auto target = test::shuffled(test::moved(source, 5), 6);
    const FrontiersResult result = match_frontiers(source, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    ASSERT_EQ(result.components.size(), 7U);
    EXPECT_EQ(result.components[0].n_interchangeable, 1);
    EXPECT_EQ(result.components[1].n_interchangeable, 5);
}

TEST(MatchFrontiers, GivenSourcesChooseAmongComponentsAlike) {
    const TriangleMesh grid = irregular_grid(6, 5, 1);
    const TriangleMesh two = joined({grid, grid});  // one upon the other
    FrontiersOptions options;
    options.source_seed = 7;
    options.target_seed = 7 + grid.n_vertices();
    const VertexMap map = match_frontiers(two, two, options).target_from_source;
    for (Index v = 0; v < two.n_vertices(); ++v)
        EXPECT_EQ(map[v], (v + grid.n_vertices()) % two.n_vertices());
    TriangleMesh different = joined({grid, irregular_grid(6, 4, 1)});
    options.target_seed = grid.n_vertices() + 3;
    EXPECT_NE(refusal(different, different, options).find("components of different connectivity"),
              std::string::npos);
}

TEST(MatchFrontiers, CanBeStoppedInEveryStage) {
    const TriangleMesh mesh = make_torus(36, 18);  // whose regular loops positions must decide
    for (const bool paper : {false, true}) {
        for (const double limit : {0.0, 0.3, 0.5, 0.9}) {
            FrontiersOptions options;
            options.paper = paper;
            options.progress = [&](double fraction) { return fraction <= limit; };
            EXPECT_THROW(match_frontiers(mesh, mesh, options), Canceled) << limit;
        }
    }
}

TEST(MatchFrontiers, TellsItsProgressFromTheCallingThread) {
    std::vector<double> fractions;
    const auto caller = std::this_thread::get_id();
    FrontiersOptions options;
    options.progress = [&](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        fractions.push_back(fraction);
        return true;
    };
    match_frontiers(make_torus(24, 12), make_torus(24, 12), options);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
}

}  // namespace
}  // namespace counterpart
