// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/islands.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

class WithoutIslands : public testing::Test {
  protected:
    const TriangleMesh grid = make_grid(20, 20);
    std::vector<Index> map = std::vector<Index>(441);
    WithoutIslands() { std::iota(map.begin(), map.end(), 0); }
};

TEST_F(WithoutIslands, AMapThatHoldsTogetherStays) {
    EXPECT_EQ(without_islands(map, grid, grid, {}), map);
    for (std::size_t v = 100; v < 150; ++v) map[v] = -1;
    EXPECT_EQ(without_islands(map, grid, grid, {}), map);
}

// The last three rows go where the first ones go.
TEST_F(WithoutIslands, APatchThatLeapsIsUnmatched) {
    for (std::size_t v = 441 - 63; v < 441; ++v) map[v] -= 441 - 63;
    std::vector<Index> expected = map;
    std::fill(expected.end() - 63, expected.end(), -1);
    EXPECT_EQ(without_islands(map, grid, grid, {}), expected);
    EXPECT_EQ(without_islands(map, grid, grid, {.min_share = 0.1}), map);
}

TEST_F(WithoutIslands, EveryComponentKeepsItsLargestRegion) {
    TriangleMesh two = grid;
    const TriangleMesh small = make_grid(2, 2);
    two.vertices.conservativeResize(441 + 9, 3);
    two.vertices.bottomRows(9) = (0.1 * small.vertices).rowwise() + Eigen::RowVector3d(0, 0, 3);
    two.triangles.conservativeResize(grid.n_triangles() + 8, 3);
    two.triangles.bottomRows(8) = small.triangles.array() + 441;
    map.resize(450);
    std::iota(map.begin(), map.end(), 0);
    EXPECT_EQ(without_islands(map, two, two, {}), map);
}

}  // namespace
}  // namespace counterpart::partial_match
