// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes that lie in the same place.
#include "support/cuts.hpp"
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/messages.hpp"
#include "support/polygons.hpp"
#include "support/quick_match.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::quick;

TEST(MatchPlace, RefusesInvalidMeshes) {
    EXPECT_THROW(match_place({}, make_grid(1, 1)), InvalidInput);
    TriangleMesh flat = make_grid(3, 3), other = flat;
    flat.vertices.setZero();
    other.vertices.setZero();
    other.vertices(0, 0) = 1;
    EXPECT_THROW(match_place(flat, other), UnsuitableMesh);
}

// Whatever was cut how, even where connectivity is alike in many ways.
TEST(MatchPlace, VerticesAtTheSamePlacesWhateverTheirTriangles) {
    const TriangleMesh quads = test::make_quads(make_icosphere(2));
    const ShuffleResult target = shuffle(test::cut_at_random(quads, 8), 4);
    const TriangleMesh source = test::cut_at_random(quads, 7);
    const MatchResult result = match(source, target.mesh, quick());
    EXPECT_EQ(result.target_from_source.image(), target.shuffled_from_original);
    TriangleMesh lacking = target.mesh;  // one triangle, so that connectivity differs in number, too
    lacking.triangles.conservativeResize(lacking.n_triangles() - 1, 3);
    const MatchResult other = match(source, lacking, quick());
    EXPECT_EQ(other.method, MatchMethod::place);
    EXPECT_EQ(other.target_from_source.image(), target.shuffled_from_original);
    EXPECT_EQ(other.confidence, Vector::Ones(source.n_vertices()));
    test::expect_part(other.reason, "the vertices of both meshes lie at the same places");
}

// Surfaces of few large triangles are not in one place because their triangles are large.
TEST(MatchPlace, CoarseShapesOfOneFrameAreNotTheSameSurface) {
    const TriangleMesh ball = make_icosphere(0);
    TriangleMesh spindle = ball;
    spindle.vertices.col(0) *= 0.7;
    EXPECT_FALSE(coincides(match_place(ball, spindle)));
    EXPECT_TRUE(coincides(match_place(ball, ball)));
}

TEST(MatchPlace, WhatLiesApartIsSaidToBeUnmatched) {
    TriangleMesh far = make_icosphere(2);
    far.vertices.col(0).array() += 10;
    const PlaceResult result = match_place(make_icosphere(2), far);
    EXPECT_FALSE(coincides(result));
    EXPECT_EQ(result.confidence.maxCoeff(), 0);
    test::expect_part(result.sentence, "do not lie in the same place");
}

// A cone that was never welded: all triangles have a tip of their own at one place.
TEST(MatchPlace, ManyVerticesAtOnePlaceTakeNoMemoryForEachPairOfThem) {
    constexpr Index n = 20000;
    TriangleMesh cone{Points(2 * n, 3), Triangles(n, 3)};
    for (Index i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n;
        cone.vertices.row(i) << std::cos(angle), std::sin(angle), 0;
        cone.vertices.row(n + i) << 0, 0, 1;
        cone.triangles.row(i) << i, (i + 1) % n, n + i;
    }
    EXPECT_FALSE(match_place(cone, cone).same_vertices);
}

// Both sides of a seam lie at one place: the faces tell which is which.
TEST(MatchPlace, VerticesThatLieTogetherAreToldApartByTheirFaces) {
    TriangleMesh ball = make_icosphere(2), half = ball;
    half.vertices.col(0).array() += 2;  // touches the first at (1, 0, 0) only if a vertex lies there
    TriangleMesh two = test::joined(ball, ball);
    two.vertices.bottomRows(ball.n_vertices()) *= 0.5;
    two.vertices.row(ball.n_vertices()) = two.vertices.row(5);  // a spike to the outer ball
    const ShuffleResult target = shuffle(two, 3);
    const PlaceResult result = match_place(two, target.mesh);
    EXPECT_TRUE(result.same_vertices);
    EXPECT_EQ(result.target_from_source.image(), target.shuffled_from_original);
}

TriangleMesh row_of_balls(int subdivisions) {
    TriangleMesh row = make_icosphere(subdivisions);
    for (int i = 1; i < 4; ++i) {
        TriangleMesh next = make_icosphere(subdivisions);
        next.vertices.col(0).array() += 2 * i;
        row = test::joined(row, next);
    }
    return row;
}

TEST(MatchPlace, PartsOfCoincidingSurfacesGoToTheirOwn) {
    const TriangleMesh source = row_of_balls(3);
    TriangleMesh target = row_of_balls(2);
    Points turned = target.vertices;  // about the row, so that no vertices coincide
    turned.col(1) = std::cos(0.3) * target.vertices.col(1) - std::sin(0.3) * target.vertices.col(2);
    turned.col(2) = std::sin(0.3) * target.vertices.col(1) + std::cos(0.3) * target.vertices.col(2);
    target.vertices = turned;
    const MatchResult result = match(source, target, quick());
    ASSERT_EQ(result.method, MatchMethod::place) << result.reason;
    const Index n = source.n_vertices() / 4, m = target.n_vertices() / 4;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        ASSERT_EQ(v / n, result.target_from_source[v] / m) << v;
        EXPECT_LT(result.confidence[v], 1);
        EXPECT_LT((source.vertices.row(v) - target.vertices.row(result.target_from_source[v])).norm(), 0.25);
    }
}

TEST(MatchPlace, OtherPosesAndOtherPlacesDoNotCoincide) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const TriangleMesh other = retriangulate(body, {.kept_share = 0.7}).mesh;
    EXPECT_TRUE(coincides(match_place(body, other)));
    EXPECT_FALSE(coincides(match_place(body, deform(other, {.bend = 0.4}))));
    EXPECT_FALSE(coincides(match_place(body, test::moved(other, 1))));
}

// A scan's part, triangulated anew, as the first file of two and as the second.
TEST(MatchPlace, APartLiesWhereItWasCut) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    const double middle = body.vertices.col(1).mean();
    const TriangleMesh whole = retriangulate(body, {.kept_share = 0.7}).mesh,
                       part = test::cut_by_plane(body, {0, 1, 0}, middle).mesh;
    const MatchResult from_part = match(part, whole, quick());
    ASSERT_EQ(from_part.method, MatchMethod::place) << from_part.reason;
    test::expect_part(from_part.reason, "the source shows a part of the target");
    const double edge = mean_edge_length(whole);
    for (Index v = 0; v < part.n_vertices(); ++v)
        EXPECT_LT((part.vertices.row(v) - whole.vertices.row(from_part.target_from_source[v])).norm(),
                  3 * edge);
    EXPECT_EQ(verdict(from_part).advice, Advice::use) << test::lines_of(from_part.messages);

    const MatchResult from_whole = match(whole, part, quick());
    ASSERT_EQ(from_whole.method, MatchMethod::place) << from_whole.reason;
    Index n_cut = 0, n_kept = 0, n_lost = 0;
    for (Index v = 0; v < whole.n_vertices(); ++v) {
        const Index image = from_whole.target_from_source[v];
        const double above = whole.vertices(v, 1) - middle;
        if (above < -edge && image != VertexMap::unmatched) ++n_cut;
        if (above > edge) ++(image == VertexMap::unmatched ? n_lost : n_kept);
    }
    EXPECT_EQ(n_cut, 0);
    EXPECT_GT(n_kept, 0);
    EXPECT_LT(n_lost, 0.1 * n_kept);
    EXPECT_EQ(verdict(from_whole).advice, Advice::use) << test::lines_of(from_whole.messages);
    EXPECT_FALSE(coincides(match_place(part, test::moved(whole, 1))));
}

// Connectivity is alike in 60 ways, of which none lays the blob on itself.
TEST(MatchPlace, WrapsOfOneBlobAreMatchedByPlace) {
    const auto on_blob = [](TriangleMesh mesh) {
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            const Eigen::RowVector3d x = mesh.vertices.row(v).normalized();
            mesh.vertices.row(v) *= 1 + 0.2 * std::sin(2 * x[0] + 1) + 0.15 * std::cos(3 * x[1]) * x[2];
        }
        return mesh;
    };
    TriangleMesh turned = make_icosphere(3);
    const Points ball = turned.vertices;
    turned.vertices.col(0) = std::cos(0.5) * ball.col(0) - std::sin(0.5) * ball.col(1);
    turned.vertices.col(1) = std::sin(0.5) * ball.col(0) + std::cos(0.5) * ball.col(1);
    const TriangleMesh source = on_blob(make_icosphere(3)), target = on_blob(turned);
    const MatchResult result = match(source, target, quick());
    double sum = 0;
    for (Index v = 0; v < source.n_vertices(); ++v)
        sum += (source.vertices.row(v) - target.vertices.row(result.target_from_source[v])).norm();
    EXPECT_LT(sum / source.n_vertices(), 0.1) << result.reason;
    EXPECT_LT(result.confidence.maxCoeff(), 1);
}

}  // namespace
}  // namespace counterpart
