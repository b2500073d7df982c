// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/map_quality.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(MapQuality, RefusesAMapThatDoesNotFit) {
    EXPECT_THROW(map_quality(identity_map(3), make_grid(1, 1), make_grid(1, 1)), InvalidInput);
}

TEST(MapQuality, OfTheTrueMap) {
    const TriangleMesh mesh = make_torus(8, 6);
    const test::DisguisedMesh disguised = test::shuffled(mesh, 1);
    const MapQuality quality = map_quality(disguised.mesh_from_original, mesh, disguised.mesh);
    EXPECT_EQ(quality.n_matched, 48);
    EXPECT_EQ(quality.n_distinct, 48);
    EXPECT_EQ(quality.coverage, 1);
    EXPECT_EQ(quality.preserved_edges, 1);
    EXPECT_EQ(quality.collapsed_edges, 0);
}

TEST(MapQuality, CountsEdgesOfAGridCell) {
    // Edges 0-1, 1-3, 0-3, 2-3, 0-2. Vertex 2 goes where 1 goes; 0 and 3 stay: nothing breaks.
    const TriangleMesh cell = make_grid(1, 1);
    const MapQuality folded = map_quality({{0, 1, 1, 3}, 4}, cell, cell);
    EXPECT_EQ(folded.n_distinct, 3);
    EXPECT_DOUBLE_EQ(folded.coverage, 0.75);
    EXPECT_DOUBLE_EQ(folded.preserved_edges, 1);
    // 0 to 2, whose neighbors are 0 and 3: 0-1 breaks; 0-2 shrinks to a point.
    const MapQuality broken = map_quality({{2, 1, 2, 3}, 4}, cell, cell);
    EXPECT_DOUBLE_EQ(broken.collapsed_edges, 0.2);
    EXPECT_DOUBLE_EQ(broken.preserved_edges, 0.6);
    // Only 1-3 keeps both ends.
    const MapQuality partial = map_quality({{-1, 1, -1, 3}, 4}, cell, cell);
    EXPECT_EQ(partial.n_matched, 2);
    EXPECT_DOUBLE_EQ(partial.preserved_edges, 1);
    const MapQuality none = map_quality({{-1, -1, -1, -1}, 4}, cell, cell);
    EXPECT_EQ(none.preserved_edges, 0);
    EXPECT_EQ(none.coverage, 0);
}

}  // namespace
}  // namespace counterpart
