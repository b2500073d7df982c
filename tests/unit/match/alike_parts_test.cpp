// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Teeth and claws that connectivity does not tell apart stay with their limb.
#include "support/edits.hpp"
#include "support/ogre.hpp"
#include "support/polygons.hpp"

#include <counterpart/match/choose_method.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(AlikeParts, OfATwistedOgreStayWithTheirLimb) {
    const TriangleMesh ogre = test::make_ogre();
    for (const double degrees : {20, 30, 40}) {
        const TriangleMesh posed = deform(ogre, {.twist = degrees * std::numbers::pi / 180});
        const ShuffleResult other = shuffle(move_at_random(posed, 3), 5);
        const ExactResult result = match_exact(ogre, other.mesh);
        ASSERT_TRUE(result.identical);
        EXPECT_EQ(result.n_components, 45);
        ASSERT_EQ(result.interchangeable.size(), 1U);
        EXPECT_EQ(result.interchangeable[0].source.size(), 44U);
        Index wrong = 0;
        for (Index v = 0; v < ogre.n_vertices(); ++v)
            wrong +=
                result.target_from_source[v] != other.shuffled_from_original[static_cast<std::size_t>(v)];
        EXPECT_LE(wrong, ogre.n_vertices() / 200) << degrees << " degrees";
    }
}

// A ball of n x m quads with poles: alike when it is turned by a segment, or upside down.
TriangleMesh eye(Index n_segments, Index n_rings, const Eigen::RowVector3d& center, double radius) {
    TriangleMesh mesh;
    mesh.vertices.resize(n_segments * (n_rings - 1) + 2, 3);
    const double pi = std::numbers::pi;
    for (Index r = 1; r < n_rings; ++r)
        for (Index s = 0; s < n_segments; ++s) {
            const double polar = pi * r / n_rings, angle = 2 * pi * s / n_segments;
            mesh.vertices.row((r - 1) * n_segments + s) << std::sin(polar) * std::cos(angle),
                std::sin(polar) * std::sin(angle), std::cos(polar);
        }
    const Index north = n_segments * (n_rings - 1), south = north + 1;
    mesh.vertices.row(north) << 0, 0, 1;
    mesh.vertices.row(south) << 0, 0, -1;
    mesh.vertices = (radius * mesh.vertices).rowwise() + center;
    std::vector<std::array<Index, 3>> faces;
    for (Index s = 0; s < n_segments; ++s) {
        const Index next = (s + 1) % n_segments, last = (n_rings - 2) * n_segments;
        faces.push_back({north, s, next});
        faces.push_back({south, last + next, last + s});
        for (Index r = 0; r + 2 < n_rings; ++r) {
            const Index a = r * n_segments + s, b = r * n_segments + next;
            faces.push_back({a, a + n_segments, b + n_segments});
            faces.push_back({a, b + n_segments, b});
        }
    }
    mesh.triangles.resize(static_cast<Eigen::Index>(faces.size()), 3);
    for (std::size_t t = 0; t < faces.size(); ++t)
        for (int c = 0; c < 3; ++c)
            mesh.triangles(static_cast<Index>(t), c) = faces[t][static_cast<std::size_t>(c)];
    return mesh;
}

// Eyes in a head that is bent: they do not turn in it.
TEST(AlikeParts, OfABentHeadMoveWithWhatTheySitIn) {
    const TriangleMesh skull = test::with_flipped_edges(make_icosphere(4), 100, 7).mesh;
    const TriangleMesh head = test::joined(test::joined(skull, eye(32, 16, {0.35, 0.3, 0.85}, 0.2)),
                                           eye(32, 16, {-0.35, 0.3, 0.85}, 0.2));
    for (const double bend : {0.02, 0.05, 0.15}) {
        TriangleMesh bent = head;
        for (Index v = 0; v < head.n_vertices(); ++v) {
            const Eigen::RowVector3d x = head.vertices.row(v);
            bent.vertices.row(v) +=
                2 * bend * Eigen::RowVector3d(std::sin(2 * x[1]), std::sin(2 * x[2]), std::sin(2 * x[0]));
        }
        const ShuffleResult other = shuffle(move_at_random(bent, 3), 5);
        const ExactResult result = match_exact(head, other.mesh);
        ASSERT_TRUE(result.identical);
        Index wrong = 0;
        for (Index v = 0; v < head.n_vertices(); ++v)
            wrong +=
                result.target_from_source[v] != other.shuffled_from_original[static_cast<std::size_t>(v)];
        EXPECT_EQ(wrong, 0) << bend;
        EXPECT_EQ(result.by_place.front(), skull.n_vertices());  // the eyes
        EXPECT_EQ(result.by_place.size(), static_cast<std::size_t>(head.n_vertices() - skull.n_vertices()));
    }
}

// Modeled by hand they are not quite alike; what a bend does to lengths is more than that, and may favor a
// turn.
TEST(AlikeParts, ThatAreNearlySoDoNotTurnByWhatABendDoesToLengths) {
    const TriangleMesh skull = test::with_flipped_edges(make_icosphere(4), 100, 7).mesh;
    for (unsigned seed = 0; seed < 8; ++seed) {
        std::mt19937 random(seed);
        TriangleMesh head = skull;
        for (const double side : {0.35, -0.35}) {
            const Eigen::RowVector3d center(side, 0.3, 0.85);
            TriangleMesh ball = eye(16, 8, {0, 0, 0}, 0.2);
            ball.vertices.col(2) *= 0.5;
            for (double& x : ball.vertices.reshaped())
                x += 4e-4 * std::uniform_real_distribution(-1.0, 1.0)(random);
            ball.vertices.rowwise() += center;
            head = test::joined(head, ball);
        }
        TriangleMesh bent = head;
        for (Index v = 0; v < head.n_vertices(); ++v)
            bent.vertices(v, 1) += 0.2 * std::sin(3 * head.vertices(v, 2));
        const ShuffleResult other = shuffle(bent, 5);
        EXPECT_EQ(match_exact(head, other.mesh).target_from_source.image(), other.shuffled_from_original)
            << seed;
    }
}

// Of quads in one file and triangles in the other, cut along other diagonals, too.
TEST(AlikeParts, OfQuadsAndOfTheirTrianglesMoveWithWhatTheySitIn) {
    test::PolygonList polygons = test::polygons_of(test::with_flipped_edges(make_icosphere(3), 40, 7).mesh);
    for (const double side : {0.35, -0.35}) {
        const TriangleMesh ball = eye(16, 8, {side, 0.3, 0.85}, 0.2);
        const auto n_before = static_cast<Index>(polygons.vertices.size());
        for (Index v = 0; v < ball.n_vertices(); ++v) polygons.vertices.push_back(ball.vertices.row(v));
        for (Index t = 0; t < ball.n_triangles(); ++t) {
            const Index a = n_before + ball.triangles(t, 0), b = n_before + ball.triangles(t, 1),
                        c = n_before + ball.triangles(t, 2);
            const bool is_half = t % 14 >= 2;  // the poles' triangles come before the quads of a segment
            if (is_half && t % 2 == 0) polygons.add({a, b, c, n_before + ball.triangles(t + 1, 2)});
            if (!is_half) polygons.add({a, b, c});
        }
    }
    const TriangleMesh head = polygons.cut();
    for (const double bend : {0.05, 0.1, 0.2}) {
        TriangleMesh bent = head;
        for (Index v = 0; v < head.n_vertices(); ++v)
            bent.vertices(v, 1) += bend * std::sin(3 * head.vertices(v, 2));
        const ShuffleResult other = shuffle(test::cut_at_random(bent, 3), 5);
        EXPECT_EQ(match_exact(head, other.mesh).target_from_source.image(), other.shuffled_from_original);
    }
}

// Spheres, eggs and rings are alike in many ways; bent, they are still what they were.
TEST(AlikeParts, BentSpheresAndRingsKeepTheirConnectivity) {
    TriangleMesh egg = make_icosphere(3);
    egg.vertices.col(1) *= 1.5;
    egg.vertices.col(2) *= 0.8;
    const std::vector<DeformOptions> poses = {{.bend = 1}, {.twist = 0.5}, {.warp = 0.08}};
    for (const TriangleMesh& mesh : {make_icosphere(3), make_torus(30, 15), egg}) {
        for (const DeformOptions& pose : poses) {
            const ShuffleResult other = shuffle(move_at_random(deform(mesh, pose), 3), 4);
            EXPECT_EQ(match(mesh, other.mesh).method, MatchMethod::exact);
            EXPECT_EQ(match(other.mesh, mesh).method, MatchMethod::exact);
        }
    }
}

// The same, of shapes that are not alike in themselves; and wraps of two of them have nothing in common.
TEST(AlikeParts, BlobsOfOneTriangulationAreToldApart) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        TriangleMesh blob = deform(make_icosphere(3), {.warp = 0.25, .seed = seed});
        blob.vertices.col(1) *= 1.5;
        const ShuffleResult bent = shuffle(move_at_random(deform(blob, {.bend = 1, .warp = 0.1}), 3), 4);
        const MatchResult result = match(blob, bent.mesh);
        EXPECT_EQ(result.method, MatchMethod::exact) << result.reason;
        EXPECT_EQ(result.target_from_source.image(), bent.shuffled_from_original);
        const TriangleMesh stranger = deform(make_icosphere(3), {.warp = 0.25, .seed = seed + 7});
        EXPECT_NE(choose_method(blob, shuffle(stranger, 4).mesh).method, MatchMethod::exact);
    }
}

// What lengths of edges tell needs no place; what only place tells is never certain.
TEST(AlikeParts, AreLessThanCertain) {
    const TriangleMesh ring = make_torus(24, 12);
    TriangleMesh dented = ring;
    for (Index v = 0; v < ring.n_vertices(); ++v) dented.vertices.row(v) *= 1 + 0.3 * std::sin(2.7 * v);
    EXPECT_TRUE(match_exact(dented, shuffle(dented, 2).mesh).by_place.empty());
    const MatchResult result = match(ring, shuffle(ring, 2).mesh);
    ASSERT_EQ(result.method, MatchMethod::exact);
    EXPECT_LT(result.confidence.maxCoeff(), 1);
    EXPECT_EQ(verdict(result).advice, Advice::use);
}

}  // namespace
}  // namespace counterpart
