// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Exports of one mesh of quads that were cut along different diagonals and know nothing of the quads.
#include "support/edits.hpp"
#include "support/polygons.hpp"

#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TriangleMesh character(int subdivisions = 1) {
    return test::make_quads(make_body({.subdivisions = subdivisions}));
}

// Every vertex has its partner, and every corner of a triangle goes to one at the image of its vertex.
void expect_found(const TriangleMesh& source, const ShuffleResult& target, const ExactResult& result) {
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(result.target_from_source.image(), target.shuffled_from_original);
    for (Index t = 0; t < source.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            ASSERT_EQ(target.mesh.triangles.data()[result.target_corner_from_source(t, c)],
                      result.target_from_source[source.triangles(t, c)]);
    EXPECT_TRUE(contains(result.messages, MessageCode::recut_polygons));
}

// The quads of which the two cuts take different diagonals.
Index count_different(const TriangleMesh& a, const TriangleMesh& b) {
    const auto edge_sums = [](const TriangleMesh& mesh) {
        std::vector<std::array<Index, 3>> all;
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            all.push_back({mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)});
            std::sort(all.back().begin(), all.back().end());
        }
        std::sort(all.begin(), all.end());
        return all;
    };
    const auto ours = edge_sums(a), theirs = edge_sums(b);
    std::vector<std::array<Index, 3>> only_ours;
    std::set_difference(ours.begin(), ours.end(), theirs.begin(), theirs.end(),
                        std::back_inserter(only_ours));
    return static_cast<Index>(only_ours.size() / 2);
}

TEST(MatchDiagonals, QuadsAgainstTheirTriangles) {
    const TriangleMesh quads = character(), triangles = test::cut_at_random(quads, 7);
    const ShuffleResult target = shuffle(move_at_random(deform(triangles, {.bend = 0.8}), 3), 4);
    const ExactResult result = match_exact(quads, target.mesh);
    expect_found(quads, target, result);
    EXPECT_EQ(result.recut_polygons, count_different(quads, triangles));
    const ShuffleResult back = shuffle(move_at_random(deform(quads, {.bend = 0.8}), 3), 4);
    expect_found(triangles, back, match_exact(triangles, back.mesh));
}

TEST(MatchDiagonals, TrianglesAgainstTriangles) {
    const TriangleMesh quads = character();
    const TriangleMesh source = test::cut_at_random(quads, 7), other = test::cut_at_random(quads, 8);
    const ShuffleResult target = shuffle(move_at_random(other, 3), 4);
    const ExactResult result = match_exact(source, target.mesh);
    expect_found(source, target, result);
    EXPECT_EQ(result.recut_polygons, count_different(source, other));
}

TEST(MatchDiagonals, WindingMayBeReversed) {
    const TriangleMesh quads = character();
    const TriangleMesh source = test::cut_at_random(quads, 7);
    TriangleMesh other = test::cut_at_random(quads, 8);
    other.triangles.col(1).swap(other.triangles.col(2));
    const ShuffleResult target = shuffle(other, 4);
    const ExactResult result = match_exact(source, target.mesh);
    expect_found(source, target, result);
    EXPECT_TRUE(result.winding_reversed);
}

TEST(MatchDiagonals, AGridAndTwoComponentsAsTheyLie) {
    test::PolygonList list;
    const TriangleMesh points = make_grid(20, 15);
    for (Index v = 0; v < points.n_vertices(); ++v) list.vertices.emplace_back(points.vertices.row(v));
    for (Index y = 0; y < 15; ++y)
        for (Index x = 0; x < 20; ++x)
            list.add({21 * y + x, 21 * y + x + 1, 21 * y + x + 22, 21 * y + x + 21});
    const TriangleMesh grid = list.cut();
    TriangleMesh moved = grid;
    moved.vertices.rowwise() += Eigen::RowVector3d(3, 1, 0.5);
    const auto cut = [&](std::uint64_t seed) {
        return test::joined(test::cut_at_random(grid, seed), test::cut_at_random(moved, seed + 1));
    };
    const TriangleMesh source = cut(1);
    const ShuffleResult target = shuffle(cut(5), 9);
    expect_found(source, target, match_exact(source, target.mesh));
}

// One flipped edge is an edit, which find_differences names.
TEST(MatchDiagonals, AnEditIsNoOtherCut) {
    const TriangleMesh mesh = make_body({.subdivisions = 1});
    EXPECT_FALSE(match_exact(mesh, test::with_flipped_edges(mesh, 1, 3).mesh).identical);
    EXPECT_FALSE(match_exact(mesh, test::with_flipped_edges(mesh, 20, 3).mesh).identical);
}

// Triangles where the quads are not the same.
TEST(MatchDiagonals, OtherQuadsAreNotFound) {
    const TriangleMesh quads = character(0), triangles = test::cut_at_random(quads, 7);
    const TriangleMesh target = test::with_flipped_edges(triangles, 40, 3).mesh;
    EXPECT_FALSE(match_exact(quads, target).identical);
}

}  // namespace
}  // namespace counterpart
