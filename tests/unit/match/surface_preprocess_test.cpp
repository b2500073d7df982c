// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/preprocess.hpp"
#include "support/edits.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using surface_match::preprocess;
using surface_match::Preprocessed;

std::vector<Index> counting(Index n) {
    std::vector<Index> numbers(static_cast<std::size_t>(n));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

TEST(SurfacePreprocess, IsTheWholeOfAGoodMesh) {
    const TriangleMesh torus = make_torus(12, 8);
    const Preprocessed result = preprocess(torus);
    EXPECT_EQ(result.mesh.vertices, torus.vertices);
    EXPECT_EQ(result.mesh.triangles, torus.triangles);
    EXPECT_EQ(result.matched_of_input, counting(96));
    EXPECT_EQ(result.input_of_matched, counting(96));
    EXPECT_EQ(result.n_merged + result.n_unreferenced + result.n_small_components + result.n_boundary_loops,
              0);
    EXPECT_EQ(result.n_components, 1);
}

TEST(SurfacePreprocess, JoinsASoupOfTriangles) {
    const TriangleMesh ball = make_icosphere(2);
    const TriangleMesh soup = test::with_separate_triangles(ball);
    const Preprocessed result = preprocess(soup);
    EXPECT_EQ(result.mesh.n_vertices(), ball.n_vertices());
    EXPECT_EQ(result.n_merged, soup.n_vertices() - ball.n_vertices());
    EXPECT_EQ(result.n_boundary_loops, 0);
    for (Index v = 0; v < soup.n_vertices(); ++v)
        EXPECT_EQ(result.mesh.vertices.row(result.matched_of_input[static_cast<std::size_t>(v)]),
                  soup.vertices.row(v));
}

TEST(SurfacePreprocess, LeavesOutCrumbsAndLooseVertices) {
    TriangleMesh crumb = make_icosphere(0);
    crumb.vertices *= 0.05;
    crumb.vertices.rowwise() += Eigen::RowVector3d(0, 0, 1.5);
    TriangleMesh mesh = test::joined(crumb, make_icosphere(3));
    mesh.vertices.conservativeResize(mesh.n_vertices() + 1, 3);
    mesh.vertices.bottomRows(1) << 0, 0, -2;
    const Preprocessed result = preprocess(mesh);
    EXPECT_EQ(result.mesh.n_vertices(), make_icosphere(3).n_vertices());
    EXPECT_EQ(result.n_small_components, 1);
    EXPECT_NEAR(result.small_share, 0.002, 0.0005);
    EXPECT_EQ(result.n_unreferenced, 1);
    EXPECT_EQ(result.n_components, 1);
    std::vector<Index> left_out = counting(12);
    left_out.push_back(mesh.n_vertices() - 1);
    EXPECT_EQ(result.left_out, left_out);
    EXPECT_GT(result.mesh.vertices(result.matched_of_input[0], 2), 0.9);  // of the crumb: near the north pole
    EXPECT_LT(result.mesh.vertices(result.matched_of_input.back(), 2),
              -0.9);  // the loose one: near the south pole
    for (std::size_t c = 0; c < result.input_of_matched.size(); ++c)
        EXPECT_EQ(result.matched_of_input[static_cast<std::size_t>(result.input_of_matched[c])],
                  static_cast<Index>(c));
}

TEST(SurfacePreprocess, LeavesOutRepeatedTriangles) {
    const TriangleMesh ball = make_icosphere(2);
    TriangleMesh twice{ball.vertices, Triangles(2 * ball.n_triangles(), 3)};
    twice.triangles << ball.triangles, ball.triangles.rowwise().reverse();
    const Preprocessed result = preprocess(twice);
    EXPECT_EQ(result.mesh.triangles, ball.triangles);
    EXPECT_EQ(result.n_duplicate_triangles, ball.n_triangles());
    EXPECT_EQ(result.n_nonmanifold_edges, 0);
}

TEST(SurfacePreprocess, LeavesOutComponentsBelowATenthOfTheLargest) {
    TriangleMesh speck = make_icosphere(2), other = make_icosphere(2);
    speck.vertices *= 0.25;  // a sixteenth
    speck.vertices.col(0).array() += 3;
    other.vertices *= 0.4;  // a sixth
    other.vertices.col(0).array() -= 3;
    const Preprocessed result = preprocess(test::joined(test::joined(speck, other), make_icosphere(2)));
    EXPECT_EQ(result.n_components, 2);
    EXPECT_EQ(result.n_small_components, 1);
}

TEST(SurfacePreprocess, KeepsEqualPiecesHoweverMany) {
    TriangleMesh dust{Points(600, 3), Triangles(200, 3)};
    for (Index t = 0; t < 200; ++t) {
        for (int c = 0; c < 3; ++c) {
            dust.vertices.row(3 * t + c) << 2 * t + (c == 1), (c == 2), 0;
            dust.triangles(t, c) = 3 * t + c;
        }
    }
    EXPECT_EQ(preprocess(dust).n_components, 200);
}

TEST(SurfacePreprocess, MapsGoBackToTheInputs) {
    Preprocessed source, target;
    source.matched_of_input = {1, 0, 1};
    target.matched_of_input = {0, 0, 1, 1};
    target.input_of_matched = {1, 3};
    const VertexMap map = between_inputs({{0, 1}, 2}, source, target);
    EXPECT_EQ(map.image(), (std::vector<Index>{3, 1, 3}));
    EXPECT_EQ(map.target_size(), 4);
}

}  // namespace
}  // namespace counterpart
