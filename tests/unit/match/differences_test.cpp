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

// A scan of which the left half is cut into triangles at random, the right half into a regular grid of so
// many columns.
TriangleMesh half_regular_scan(Index columns) {
    constexpr Index left = 30, rows = 40;
    const Index n_columns = left + columns;
    TriangleMesh mesh{Points((n_columns + 1) * (rows + 1), 3), Triangles(2 * n_columns * rows, 3)};
    for (Index i = 0; i <= n_columns; ++i)
        for (Index j = 0; j <= rows; ++j) {
            const double x = i <= left ? i : left + (i - left) * 30.0 / columns;
            mesh.vertices.row(i * (rows + 1) + j) << x, j, 3 * std::sin(0.2 * x + 0.1 * j);
        }
    Index t = 0;
    for (Index i = 0; i < n_columns; ++i)
        for (Index j = 0; j < rows; ++j) {
            const Index a = i * (rows + 1) + j, b = a + rows + 1, c = b + 1, d = a + 1;
            const bool turned = i < left && (7 * i * i + 13 * j * j + i * j) % 11 < 5;
            mesh.triangles.row(t++) << a, b, (turned ? d : c);
            mesh.triangles.row(t++) << (turned ? b : a), c, d;
        }
    return mesh;
}

// Growing goes on over the grid of the right half, though the target's is another: each column drifts.
TEST(FindDifferences, DoubtsGridsThatOnlyBeginAlike) {
    const TriangleMesh source = half_regular_scan(30);
    const test::DisguisedMesh target = test::shuffled(half_regular_scan(24), 3);
    const MeshDifferences found = find_differences(source, target.mesh);
    Index n_sure = 0, n_drifted = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index image = found.target_from_source[v];
        if (image < 0 || std::binary_search(found.uncertain.begin(), found.uncertain.end(), v)) continue;
        ++n_sure;
        const double away = (source.vertices.row(v) - target.mesh.vertices.row(image)).norm();
        n_drifted += away > 2 ? 1 : 0;
    }
    EXPECT_GT(n_sure, 1100);  // of the left half
    EXPECT_EQ(n_drifted, 0);
    const test::DisguisedMesh same = test::shuffled(test::without_vertex(source, 5).mesh, 3);
    EXPECT_TRUE(find_differences(source, same.mesh).untold.empty());
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
