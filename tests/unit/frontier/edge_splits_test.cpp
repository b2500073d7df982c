// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/edge_splits.hpp"

#include "frontier/subtree_hash.hpp"
#include "support/disguise.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart::frontier {
namespace {

EdgeSplits split(const TriangleMesh& mesh, Index source) {
    return split_edges_for_depth(mesh, bfs_frontiers(Adjacency(mesh), source));
}

TEST(EdgeSplits, ReachesTheDepthAndKeepsTheSurface) {
    const TriangleMesh sphere = make_icosphere(3);
    const Index before = bfs_frontiers(Adjacency(sphere), 0).count();
    ASSERT_LT(before * before, sphere.n_vertices());
    const EdgeSplits splits = split(sphere, 0);
    EXPECT_TRUE(splits.reached);
    EXPECT_EQ(splits.n_original, sphere.n_vertices());
    EXPECT_EQ(splits.mesh.vertices.topRows(sphere.n_vertices()), sphere.vertices);
    const Frontiers frontiers = bfs_frontiers(Adjacency(splits.mesh), 0);
    EXPECT_GE(frontiers.count() * frontiers.count(), splits.mesh.n_vertices());
    EXPECT_NO_THROW(require_valid(splits.mesh));
    EXPECT_NEAR(surface_area(splits.mesh), surface_area(sphere), 1e-12);
    EXPECT_NEAR(signed_volume(splits.mesh), signed_volume(sphere), 1e-12);
}

TEST(EdgeSplits, DeepMeshesStayAsTheyAre) {
    const TriangleMesh strip = make_grid(60, 1);
    const EdgeSplits splits = split(strip, 0);
    EXPECT_TRUE(splits.reached);
    EXPECT_EQ(splits.mesh.n_vertices(), strip.n_vertices());
    EXPECT_EQ(splits.mesh.n_triangles(), strip.n_triangles());
}

TEST(EdgeSplits, GivesUpWhereItWouldExplode) {
    // A fan of 1000 triangles: two frontiers.
    TriangleMesh fan{Points::Random(1001, 3), Triangles(1000, 3)};
    for (Index i = 0; i < 1000; ++i) fan.triangles.row(i) << 0, 1 + i, 1 + (i + 1) % 1000;
    const EdgeSplits splits = split(fan, 0);
    EXPECT_FALSE(splits.reached);
    EXPECT_LE(splits.mesh.n_vertices(), 8 * 1001);
}

TEST(EdgeSplits, AlikeForMeshesThatAreAlike) {
    const TriangleMesh mesh = make_icosphere(2);
    const auto disguised = test::shuffled(mesh, 5);
    const Index there = disguised.mesh_from_original[17];
    const TriangleMesh ours = split(mesh, 17).mesh, theirs = split(disguised.mesh, there).mesh;
    const Adjacency a(ours), b(theirs);
    EXPECT_EQ(subtree_hashes(ours, a, bfs_frontiers(a, 17))[17],
              subtree_hashes(theirs, b, bfs_frontiers(b, there))[static_cast<std::size_t>(there)]);
}

}  // namespace
}  // namespace counterpart::frontier
