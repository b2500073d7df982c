// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/expect_found.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh lopsided_sphere() { return test::with_flipped_edges(make_icosphere(4), 300, 7).mesh; }

TEST(FindDifferences, RefusesInvalidMeshes) {
    EXPECT_THROW(find_differences({}, make_grid(1, 1)), InvalidInput);
    DifferencesOptions options;
    options.n_threads = -1;
    EXPECT_THROW(find_differences(make_grid(1, 1), make_grid(1, 1), options), InvalidInput);
}

TEST(FindDifferences, NamesAFlippedEdge) {
    const TriangleMesh mesh = lopsided_sphere();
    for (const Index count : {1, 10, 25}) {
        const test::EditedMesh edited = test::with_flipped_edges(mesh, count, 21);
        const test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, 1), 22);
        const MeshDifferences difference = find_differences(mesh, target.mesh);
        test::expect_found(edited, 0.999, difference, target.mesh_from_original);
        if (count > 1) continue;
        ASSERT_EQ(difference.edits.size(), 1U);
        EXPECT_NE(difference.edits[0].sentence.find("is flipped"), std::string::npos);
    }
}

TEST(FindDifferences, NamesARemovedVertex) {
    const TriangleMesh mesh = lopsided_sphere();
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const test::EditedMesh edited = test::without_vertex(mesh, seed);
        const test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, 1), 22);
        const MeshDifferences difference = find_differences(mesh, target.mesh);
        test::expect_found(edited, 0.999, difference, target.mesh_from_original);
        ASSERT_EQ(difference.edits.size(), 1U);
        EXPECT_NE(difference.edits[0].sentence.find("is replaced by"), std::string::npos)
            << difference.edits[0].sentence;
    }
}

TEST(FindDifferences, FindsMissingFaces) {
    const TriangleMesh mesh = lopsided_sphere();
    const test::EditedMesh edited = test::with_missing_triangles(mesh, 0.05, 5);
    const test::DisguisedMesh target = test::shuffled(edited.mesh, 6);
    test::expect_found(edited, 0.999, find_differences(mesh, target.mesh), target.mesh_from_original);
}

// The upper half is turned about a neck that the target lacks: the lower half expects it elsewhere.
TEST(FindDifferences, BelievesALargeRegionThatItsNeighborsExpectElsewhere) {
    const TriangleMesh mesh = lopsided_sphere();
    const auto height = [&](Index t, int c) { return mesh.vertices(mesh.triangles(t, c), 2); };
    std::vector<char> kept;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        kept.push_back(height(t, 0) * height(t, 1) > 0 && height(t, 1) * height(t, 2) > 0 ? 1 : 0);
    PartOfMesh part = part_of(mesh, kept);
    for (Index v = 0; v < part.mesh.n_vertices(); ++v) {
        auto place = part.mesh.vertices.row(v);
        if (place[2] > 0) place = Eigen::RowVector3d(place[1], -place[0], place[2] + 0.2);
    }
    const test::DisguisedMesh target = test::shuffled(part.mesh, 8);
    const VertexMap found = find_differences(mesh, target.mesh).target_from_source;
    Index right = 0;
    for (Index v = 0; v < part.mesh.n_vertices(); ++v)
        right += found[part.whole_from_part[static_cast<std::size_t>(v)]] == target.mesh_from_original[v];
    EXPECT_GT(right, part.mesh.n_vertices() * 95 / 100);
}

TEST(FindDifferences, NamesAMissingComponent) {
    TriangleMesh component = make_icosphere(1);
    component.vertices.rowwise() += Eigen::RowVector3d(3, 0, 0);
    TriangleMesh other = component;
    other.vertices.rowwise() += Eigen::RowVector3d(0, 3, 0);
    const TriangleMesh part = test::joined(lopsided_sphere(), other);
    const TriangleMesh mesh = test::joined(part, component);
    const test::DisguisedMesh target = test::shuffled(part, 4);
    const MeshDifferences difference = find_differences(mesh, target.mesh);
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        EXPECT_EQ(difference.target_from_source[v],
                  v < part.n_vertices() ? target.mesh_from_original[v] : -1);
    ASSERT_EQ(difference.edits.size(), 1U);
    EXPECT_NE(difference.edits[0].sentence.find("the target lacks a component of 80 faces"),
              std::string::npos);
}

TEST(FindDifferences, FindsNothingInCommonOfUnrelatedMeshes) {
    const TriangleMesh ball = test::with_flipped_edges(make_icosphere(4), 300, 7).mesh;
    TriangleMesh other = test::with_flipped_edges(make_icosphere(4), 300, 8).mesh;
    other.vertices.col(2).array() += 0.5 * (3 * other.vertices.col(0)).array().sin();  // another shape
    for (const auto& [source, target] :
         {std::pair(make_torus(10, 12), make_grid(9, 7)), std::pair(ball, other),
          std::pair(test::with_flipped_edges(make_torus(40, 30), 200, 1).mesh, ball)}) {
        const MeshDifferences difference = find_differences(source, target);
        EXPECT_EQ(difference.n_matched_triangles, 0);
        EXPECT_EQ(count_matched(difference.target_from_source), 0);
        EXPECT_EQ(difference.source_share, 0);
        EXPECT_NE(difference.summary.find("share no part"), std::string::npos) << difference.summary;
    }
}

// Two scans of different shapes: grids agree with each other nearly everywhere.
TEST(FindDifferences, FindsNothingInCommonOfScansOnGrids) {
    const auto scan = [](int columns, int rows, double phase, std::uint64_t seed) {
        TriangleMesh mesh = make_grid(columns, rows);
        const double extent = mesh.vertices.col(0).maxCoeff();
        for (Index v = 0; v < mesh.n_vertices(); ++v)
            mesh.vertices(v, 2) = extent / 5 * std::sin(7 * mesh.vertices(v, 0) / extent + phase) *
                                  std::cos(5 * mesh.vertices(v, 1) / extent + 2 * phase);
        return test::with_flipped_edges(mesh, 8, seed).mesh;
    };
    const MeshDifferences difference = find_differences(scan(34, 28, 0, 1), scan(30, 24, 1.3, 2));
    EXPECT_EQ(count_matched(difference.target_from_source), 0) << difference.summary;
}

// Two triangles may lie anywhere on a mesh of thousands.
TEST(FindDifferences, TwoTrianglesAreNoEvidence) {
    TriangleMesh sheet = make_grid(8, 8);
    sheet.vertices.col(0).array() += 5;
    const MeshDifferences difference =
        find_differences(make_grid(1, 1), test::joined(lopsided_sphere(), sheet));
    EXPECT_EQ(count_matched(difference.target_from_source), 0) << difference.summary;
}

TEST(FindDifferences, TellsHowMuchIsShared) {
    const TriangleMesh mesh = lopsided_sphere(), ball = make_icosphere(1);
    TriangleMesh far = ball;
    far.vertices.rowwise() += Eigen::RowVector3d(5, 0, 0);
    const MeshDifferences difference =
        find_differences(mesh, test::shuffled(test::joined(mesh, far), 3).mesh);
    EXPECT_EQ(difference.source_share, 1);
    EXPECT_DOUBLE_EQ(difference.target_share,
                     double(mesh.n_vertices()) / (mesh.n_vertices() + ball.n_vertices()));
    EXPECT_EQ(difference.largest_region, mesh.n_triangles());
}

TEST(FindDifferences, SeesThatTheWindingIsReversed) {
    const TriangleMesh mesh = lopsided_sphere();
    const test::EditedMesh edited = test::with_flipped_edges(mesh, 10, 21);
    test::DisguisedMesh target = test::shuffled(test::moved(edited.mesh, 1), 22);
    target.mesh.triangles.col(1).swap(target.mesh.triangles.col(2));
    const MeshDifferences difference = find_differences(mesh, target.mesh);
    test::expect_found(edited, 0.999, difference, target.mesh_from_original);
    EXPECT_TRUE(difference.winding_reversed);
}

TEST(FindDifferences, SaysThatARegularMeshIsAmbiguous) {
    const TriangleMesh mesh = make_icosphere(3);  // 60 rotations
    const test::EditedMesh edited = test::with_missing_triangles(mesh, 0.002, 3);
    const MeshDifferences difference = find_differences(mesh, test::shuffled(edited.mesh, 4).mesh);
    EXPECT_TRUE(difference.is_ambiguous);
    EXPECT_GT(difference.source_share, 0.9);
    EXPECT_EQ(static_cast<Index>(difference.uncertain.size()), count_matched(difference.target_from_source));
}

TEST(FindDifferences, IsTheSameForAnyNumberOfThreadsAndStops) {
    const TriangleMesh mesh = lopsided_sphere();
    const test::DisguisedMesh target = test::shuffled(test::with_flipped_edges(mesh, 25, 3).mesh, 22);
    DifferencesOptions options;
    std::vector<double> seen;
    options.progress = [&](double share) { return seen.push_back(share), true; };
    const MeshDifferences all = find_differences(mesh, target.mesh, options);
    options.n_threads = 1;
    EXPECT_EQ(find_differences(mesh, target.mesh, options).target_from_source, all.target_from_source);
    const auto second = std::find(seen.begin() + 1, seen.end(), 0.0);
    EXPECT_TRUE(std::is_sorted(seen.begin(), second));
    for (const double end : {0.0, 0.3, 0.6, 0.9}) {
        options.progress = [&](double share) { return share < end; };
        EXPECT_THROW(find_differences(mesh, target.mesh, options), Canceled);
    }
}

}  // namespace
}  // namespace counterpart
