// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/subtree_hash.hpp"

#include "support/disguise.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart::frontier {
namespace {

std::vector<std::uint64_t> hashes_from(const TriangleMesh& mesh, Index source) {
    const Adjacency adjacency(mesh);
    return subtree_hashes(mesh, adjacency, bfs_frontiers(adjacency, source));
}

TEST(SubtreeHash, DoesNotDependOnNumberingOrPositions) {
    const TriangleMesh mesh = make_grid(8, 6);
    const auto disguised = test::shuffled(test::moved(mesh, 2), 3);
    const auto ours = hashes_from(mesh, 5);
    const auto theirs = hashes_from(disguised.mesh, disguised.mesh_from_original[5]);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_EQ(ours[static_cast<std::size_t>(v)],
                  theirs[static_cast<std::size_t>(disguised.mesh_from_original[v])]);
}

TEST(SubtreeHash, TheSourcesHashSeesAnyChange) {
    const TriangleMesh mesh = make_grid(8, 6);
    const std::uint64_t whole = hashes_from(mesh, 0)[0];
    EXPECT_NE(hashes_from(mesh, 1)[1], whole);
    TriangleMesh fewer = mesh;
    fewer.triangles.conservativeResize(mesh.n_triangles() - 1, 3);
    EXPECT_NE(hashes_from(fewer, 0)[0], whole);
    // The far corner's cell cut along its other diagonal.
    TriangleMesh flipped = mesh;
    const Index t = mesh.n_triangles() - 2;
    const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2),
                d = mesh.triangles(t + 1, 2);
    flipped.triangles.row(t) << a, b, d;
    flipped.triangles.row(t + 1) << b, c, d;
    EXPECT_NE(hashes_from(flipped, 0)[0], whole);
}

TEST(SubtreeHash, UnreachedVerticesHaveNone) {
    TriangleMesh two{Points::Random(6, 3), Triangles(2, 3)};
    two.triangles << 0, 1, 2, 3, 4, 5;
    const auto hashes = hashes_from(two, 0);
    EXPECT_EQ(hashes[4], 0U);
    EXPECT_EQ(hashes[1], hashes[2]);
    EXPECT_NE(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace counterpart::frontier
