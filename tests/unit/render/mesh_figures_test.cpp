// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/expect_error.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/render/color.hpp>
#include <counterpart/render/figures.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart::render {
namespace {

class MeshFigures : public testing::Test {
  protected:
    TriangleMesh grid = make_grid(20, 20);
    Placement placement{grid, find_camera(grid)};
    Frontiers frontiers = bfs_frontiers(Adjacency(grid), 0);
    Scene scene;
};

TEST_F(MeshFigures, RefuseWhatDoesNotFit) {
    const std::vector<Index> few(3, 0);
    test::expect_error<InvalidInput>([&] { add_frontiers(scene, grid, placement, few); }, "441");
    test::expect_error<InvalidInput>(
        [&] { add_frontiers(scene, grid, placement, frontiers.level, {.every = 0}); }, "1 or more");
    test::expect_error<InvalidInput>([&] { add_shortcuts(scene, grid, placement, few, 0, 0.2); }, "441");
    test::expect_error<InvalidInput>(
        [&] { add_shortcuts(scene, grid, placement, frontiers.level, 441, 0.2); }, "441");
    test::expect_error<InvalidInput>([&] { add_shortcuts(scene, grid, placement, frontiers.level, 0, 1e-6); },
                                     "larger");
    test::expect_error<InvalidInput>(
        [&] { add_farthest_point_samples(scene, make_grid(3, 3), placement, {}); }, "another mesh");
    EXPECT_TRUE(scene.surfaces.empty());
}

TEST_F(MeshFigures, DrawEveryNthFrontierAsABand) {
    add_frontiers(scene, grid, placement, frontiers.level, {.every = 5});
    ASSERT_EQ(scene.surfaces.size(), 1U);
    ASSERT_EQ(scene.dots.size(), 1U);  // the source
    EXPECT_EQ(scene.dots[0].center, placement(grid.vertices.row(0)));
    const auto color = [&](double level) { return scene.surfaces[0].color({level, 0, 0}); };
    EXPECT_EQ(color(2.5), plain_color());
    EXPECT_NE(color(5), plain_color());
    EXPECT_NE(color(5), color(10));
    EXPECT_NE(color(std::nan("")), plain_color());
}

TEST_F(MeshFigures, DrawEveryNthFrontierAsDots) {
    add_frontiers(scene, grid, placement, frontiers.level, {.every = 7, .dots = true});
    const auto drawn = std::count_if(frontiers.level.begin(), frontiers.level.end(),
                                     [](Index level) { return level % 7 == 0; });
    EXPECT_EQ(static_cast<Index>(scene.dots.size()), static_cast<Index>(drawn));
}

TEST_F(MeshFigures, DrawBaseVerticesAndTheirPatches) {
    FarthestPointSamples bases;
    bases.vertices = {0, 440};
    bases.sample_of_vertex.assign(441, 0);
    bases.sample_of_vertex[440] = 1;
    add_farthest_point_samples(scene, grid, placement, bases);
    ASSERT_EQ(scene.dots.size(), 2U);
    EXPECT_NE(scene.surfaces[0].attributes.row(0), scene.surfaces[0].attributes.row(440));
    EXPECT_EQ(scene.surfaces[0].attributes.row(0), scene.surfaces[0].attributes.row(1));
}

TEST_F(MeshFigures, DrawEdgesAndShortcutsOfAPatch) {
    const double radius = 2.1 / 20;
    add_shortcuts(scene, grid, placement, frontiers.level, 220, radius);
    const TriangleMesh patch = patch_around(grid, 220, radius);
    EXPECT_LT(patch.n_vertices(), 30);
    EXPECT_EQ(static_cast<Index>(scene.dots.size()), patch.n_vertices());
    // Every edge is gray; what is more are shortcuts.
    const Index n_edges = Adjacency(patch).n_edges();
    EXPECT_GT(static_cast<Index>(scene.tubes.size()), n_edges);
    const auto gray = std::count_if(scene.tubes.begin(), scene.tubes.end(), [](const Tube& tube) {
        return tube.color.maxCoeff() - tube.color.minCoeff() < 0.05;
    });
    EXPECT_EQ(static_cast<Index>(gray), n_edges);
}

TEST_F(MeshFigures, DrawTwoFrontiersAndTheirPairs) {
    FrontierPair pair;
    pair.first = grid.vertices.topRows(4);
    pair.second = grid.vertices.middleRows(10, 5);
    pair.first_edges = {{0, 1}, {1, 2}};
    pair.second_edges = {{0, 1}};
    pair.pairs = {{0, 4}, {3, 0}};
    add_frontier_pair(scene, pair, 0.01);
    EXPECT_EQ(scene.dots.size(), 9U);
    EXPECT_EQ(scene.tubes.size(), 5U);
    EXPECT_NE(scene.dots[0].color, scene.dots[8].color);
}

TEST_F(MeshFigures, StandInARowWithoutOverlap) {
    std::vector<Placement> row(3, placement);
    arrange_in_row(row);
    double right = -1e9;
    for (const Placement& placed : row) {
        const Points points = placed(grid).vertices;
        EXPECT_GT(points.col(0).minCoeff(), right);
        right = points.col(0).maxCoeff();
    }
}

}  // namespace
}  // namespace counterpart::render
