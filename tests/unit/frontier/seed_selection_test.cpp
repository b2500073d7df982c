// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/seed_selection.hpp"

#include "support/disguise.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart::frontier {
namespace {

// A grid without symmetry: two corners cut off differently.
TriangleMesh irregular_mesh() {
    TriangleMesh mesh = make_grid(14, 9);
    mesh.triangles = mesh.triangles.bottomRows(mesh.n_triangles() - 1).eval();
    const Index t = 100;
    const Index a = mesh.triangles(t + 1, 0), b = mesh.triangles(t + 1, 1), c = mesh.triangles(t + 1, 2),
                d = mesh.triangles(t + 2, 2);
    mesh.triangles.row(t + 1) << a, b, d;
    mesh.triangles.row(t + 2) << b, c, d;
    return mesh;
}

struct Pair {
    TriangleMesh source = irregular_mesh();
    test::DisguisedMesh disguised = test::shuffled(source, 11);
    Adjacency source_adjacency{source}, target_adjacency{disguised.mesh};
    SeedSelection select(std::vector<Index> ours, std::vector<Index> theirs) const {
        return select_seeds(source, source_adjacency, ours, disguised.mesh, target_adjacency, theirs);
    }
    Index partner(Index v) const { return disguised.mesh_from_original[v]; }
};

TEST(SeedSelection, ACandidateOfBothMeshes) {
    const Pair pair;
    const SeedSelection selection = pair.select({40, 3}, {pair.partner(3), pair.partner(40)});
    EXPECT_EQ(selection.source, 40);
    EXPECT_EQ(selection.targets, std::vector<Index>{pair.partner(40)});
    EXPECT_EQ(selection.test, SeedTest::critical_both);
    EXPECT_EQ(selection.n_alike, 1);
}

TEST(SeedSelection, ACandidateThatTheTargetLacksIsLookedUp) {
    const Pair pair;
    const SeedSelection selection = pair.select({40}, {pair.partner(3)});
    EXPECT_EQ(selection.targets, std::vector<Index>{pair.partner(40)});
    EXPECT_EQ(selection.test, SeedTest::critical_source);
}

TEST(SeedSelection, WithoutCandidatesTheEccentricVertex) {
    const Pair pair;
    const SeedSelection selection = pair.select({}, {});
    EXPECT_EQ(selection.test, SeedTest::eccentric);
    EXPECT_EQ(selection.targets, std::vector<Index>{pair.partner(selection.source)});
}

TEST(SeedSelection, ManyAlikeAreSaidAndTheTruthIsAmongTheFirst) {
    const TriangleMesh sphere = make_icosphere(1);
    const auto disguised = test::shuffled(sphere, 2);
    const Adjacency ours(sphere), theirs(disguised.mesh);
    SeedSelectionOptions options;
    options.max_targets = 12;
    const SeedSelection selection =
        select_seeds(sphere, ours, std::vector<Index>{4}, disguised.mesh, theirs, {}, options);
    EXPECT_EQ(selection.test, SeedTest::ambiguous);
    EXPECT_EQ(selection.n_alike, 12);
    EXPECT_EQ(std::count(selection.targets.begin(), selection.targets.end(),
                         disguised.mesh_from_original[selection.source]),
              1);
}

TEST(SeedSelection, OtherConnectivityIsSeen) {
    const TriangleMesh sphere = make_icosphere(2), torus = make_torus(18, 9);  // 162 vertices each
    const Adjacency ours(sphere), theirs(torus);
    const SeedSelection selection = select_seeds(sphere, ours, {}, torus, theirs, {});
    EXPECT_EQ(selection.test, SeedTest::none);
    EXPECT_TRUE(selection.targets.empty());
    EXPECT_GT(selection.longest_agreement, 0);
    EXPECT_THROW(select_seeds(sphere, ours, std::vector<Index>{999}, torus, theirs, {}), InvalidInput);
}

TEST(SeedSelection, EccentricVertexOfAStripIsAnEnd) {
    const Index end = eccentric_vertex(Adjacency(make_grid(30, 1)), 17);
    EXPECT_TRUE(end % 31 == 0 || end % 31 == 30) << end;
}

}  // namespace
}  // namespace counterpart::frontier
