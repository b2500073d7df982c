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
#include <array>
#include <cmath>

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

// A bumpy torus of n x m quads, some of them split in five.
TriangleMesh torus_of_quads(Index n, Index m, Index n_split) {
    test::PolygonList list;
    const double pi = std::acos(-1.0);
    for (Index x = 0; x < n; ++x)
        for (Index y = 0; y < m; ++y) {
            const double a = 2 * pi * x / n, b = 2 * pi * y / m,
                         r = 0.3 + 0.05 * std::sin(3 * a + 1) + 0.03 * std::cos(5 * b);
            list.vertices.emplace_back((1 + r * std::cos(b)) * std::cos(a),
                                       (1 + r * std::cos(b)) * std::sin(a), r * std::sin(b));
        }
    const auto at = [&](Index x, Index y) { return (x % n) * m + y % m; };
    for (Index x = 0; x < n; ++x)
        for (Index y = 0; y < m; ++y) {
            const std::array<Index, 4> quad{at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)};
            if (n_split == 0 || (37 * x + 11 * y) % (n * m / n_split) != 0) {
                list.add({quad.begin(), quad.end()});
                continue;
            }
            Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
            for (const Index v : quad) middle += list.vertices[static_cast<std::size_t>(v)] / 4;
            const auto first = static_cast<Index>(list.vertices.size());
            for (const Index v : quad)
                list.vertices.push_back((list.vertices[static_cast<std::size_t>(v)] + middle) / 2);
            list.add({first, first + 1, first + 2, first + 3});
            for (Index c = 0; c < 4; ++c)
                list.add({quad[static_cast<std::size_t>(c)], quad[static_cast<std::size_t>((c + 1) % 4)],
                          first + (c + 1) % 4, first + c});
        }
    return list.cut();
}

TEST(MatchDiagonals, ALargeTorusWhateverItsBend) {
    const TriangleMesh quads = torus_of_quads(90, 45, 100);
    for (const double bend : {0.0, 0.1}) {
        TriangleMesh bent = quads;
        for (Index v = 0; v < bent.n_vertices(); ++v) {
            const Eigen::RowVector3d x = quads.vertices.row(v);
            bent.vertices.row(v) +=
                bend * Eigen::RowVector3d(std::sin(2 * x[1]), std::sin(2 * x[2]), std::sin(2 * x[0]));
        }
        const ShuffleResult target = shuffle(move_at_random(test::cut_at_random(bent, 2), 3), 4);
        expect_found(test::cut_at_random(quads, 1), target,
                     match_exact(test::cut_at_random(quads, 1), target.mesh));
        expect_found(quads, target, match_exact(quads, target.mesh));
    }
}

TEST(MatchDiagonals, SomeQuadsAreNotConvex) {
    TriangleMesh quads = torus_of_quads(30, 15, 8);
    for (Index k = 0; k < 4; ++k) {  // a vertex is drawn over the diagonal
        const Index x = 5 * k + 2, y = 3 * k;
        const auto at = [&](Index i, Index j) { return quads.vertices.row((x + i) * 15 + y + j); };
        at(1, 1) = (0.7 * at(0, 0) + 0.15 * at(1, 0) + 0.15 * at(0, 1)).eval();
    }
    const TriangleMesh source = test::cut_at_random(quads, 1);
    TriangleMesh other = test::cut_at_random(quads, 2);
    for (Index v = 0; v < other.n_vertices(); ++v)
        other.vertices(v, 2) += 0.1 * std::sin(2 * other.vertices(v, 0));
    const ShuffleResult target = shuffle(move_at_random(other, 3), 4);
    expect_found(source, target, match_exact(source, target.mesh));
}

TEST(MatchDiagonals, SaysHowFarItGot) {
    const TriangleMesh quads = torus_of_quads(12, 8, 5), other = torus_of_quads(8, 12, 5);
    const ExactResult result = match_exact(test::cut_at_random(quads, 1), test::cut_at_random(other, 2));
    EXPECT_FALSE(result.identical);
    EXPECT_NE(result.difference.find("the one that gets farthest ends after"), std::string::npos)
        << result.difference;
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
