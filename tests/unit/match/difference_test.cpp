// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/expect_found.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/difference.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh lopsided() { return test::with_flipped_edges(make_icosphere(4), 300, 7).mesh; }

TEST(FindDifferences, RefusesInvalidMeshes) {
    EXPECT_THROW(find_differences({}, make_grid(1, 1)), InvalidInput);
}

TEST(FindDifferences, NamesAFlippedEdge) {
    const TriangleMesh mesh = lopsided();
    for (const Index count : {1, 10, 25}) {
        const test::EditedMesh edited = test::with_flipped_edges(mesh, count, 21);
        const test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, 1), 22);
        const MeshDifference difference = find_differences(mesh, target.mesh);
        test::expect_found(edited, 0.999, difference, target.mesh_from_original);
        if (count > 1) continue;
        ASSERT_EQ(difference.edits.size(), 1U);
        EXPECT_NE(difference.edits[0].sentence.find("is flipped"), std::string::npos);
    }
}

TEST(FindDifferences, NamesARemovedVertex) {
    const TriangleMesh mesh = lopsided();
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const test::EditedMesh edited = test::without_vertex(mesh, seed);
        const test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, 1), 22);
        const MeshDifference difference = find_differences(mesh, target.mesh);
        test::expect_found(edited, 0.999, difference, target.mesh_from_original);
        ASSERT_EQ(difference.edits.size(), 1U);
        EXPECT_NE(difference.edits[0].sentence.find("is replaced by"), std::string::npos)
            << difference.edits[0].sentence;
    }
}

TEST(FindDifferences, FindsMissingFaces) {
    const TriangleMesh mesh = lopsided();
    const test::EditedMesh edited = test::with_missing_triangles(mesh, 0.05, 5);
    const test::DisguisedMesh target = test::shuffled(edited.mesh, 6);
    test::expect_found(edited, 0.999, find_differences(mesh, target.mesh), target.mesh_from_original);
}

TEST(FindDifferences, NamesAMissingIsland) {
    TriangleMesh island = make_icosphere(1);
    island.vertices.rowwise() += Eigen::RowVector3d(3, 0, 0);
    TriangleMesh other = island;
    other.vertices.rowwise() += Eigen::RowVector3d(0, 3, 0);
    const TriangleMesh part = test::joined(lopsided(), other);
    const TriangleMesh mesh = test::joined(part, island);
    const test::DisguisedMesh target = test::shuffled(part, 4);
    const MeshDifference difference = find_differences(mesh, target.mesh);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_EQ(difference.target_from_source[v],
                  v < part.n_vertices() ? target.mesh_from_original[v] : -1);
    ASSERT_EQ(difference.edits.size(), 1U);
    EXPECT_NE(difference.edits[0].sentence.find("an island of 80 faces"), std::string::npos);
}

TEST(FindDifferences, EndsOnUnrelatedMeshes) {
    const MeshDifference difference = find_differences(make_torus(10, 12), make_grid(9, 7));
    EXPECT_FALSE(difference.summary.empty());
}

}  // namespace
}  // namespace counterpart
