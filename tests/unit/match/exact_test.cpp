// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "support/disguise.hpp"
#include "support/edits.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Every source triangle lies on a target triangle, corner by corner, each used once.
void expect_isomorphism(const TriangleMesh& source, const TriangleMesh& target, const ExactResult& result) {
    ASSERT_TRUE(result.identical) << result.difference;
    std::vector<bool> hit(static_cast<std::size_t>(target.n_vertices()), false),
        used(static_cast<std::size_t>(target.n_triangles()), false);
    for (const Index w : result.target_from_source.image()) {
        ASSERT_GE(w, 0);
        EXPECT_FALSE(hit[static_cast<std::size_t>(w)]) << "target vertex " << w << " is taken twice";
        hit[static_cast<std::size_t>(w)] = true;
    }
    for (Index t = 0; t < source.n_triangles(); ++t) {
        const Index u = result.target_corner_from_source(t, 0) / 3;
        EXPECT_FALSE(used[static_cast<std::size_t>(u)]);
        used[static_cast<std::size_t>(u)] = true;
        for (int c = 0; c < 3; ++c) {
            const Index corner = result.target_corner_from_source(t, c);
            ASSERT_EQ(corner / 3, u);
            EXPECT_EQ(result.target_from_source[source.triangles(t, c)], target.triangles(u, corner % 3));
        }
    }
}

// A closed surface without symmetry of the connectivity.
TriangleMesh lopsided() { return test::with_flipped_edges(make_icosphere(3), 40, 7).mesh; }

TriangleMesh with_reversed_winding(TriangleMesh mesh, Index every) {
    for (Index t = 0; t < mesh.n_triangles(); t += every)
        std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2));
    return mesh;
}

TEST(MatchExact, RefusesInvalidMeshesAndOptions) {
    EXPECT_THROW(match_exact({}, make_grid(1, 1)), InvalidInput);
    ExactOptions options;
    options.max_alternatives = -1;
    EXPECT_THROW(match_exact(make_grid(1, 1), make_grid(1, 1), options), InvalidInput);
    options = {};
    options.n_threads = -1;
    EXPECT_THROW(match_exact(make_grid(1, 1), make_grid(1, 1), options), InvalidInput);
}

TEST(MatchExact, FindsTheOnlyMatchOfAnAsymmetricMesh) {
    const TriangleMesh mesh = lopsided();
    const test::DisguisedMesh target = test::shuffled(test::moved(mesh, 3), 4);
    const ExactResult result = match_exact(mesh, target.mesh);
    expect_isomorphism(mesh, target.mesh, result);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.automorphisms.number, 1U);
    EXPECT_EQ(result.mirror_automorphisms.number, 0U);
    EXPECT_EQ(result.reversed_triangles, 0);
}

TEST(MatchExact, CountsTheRotationsOfAnIcosphereAndPicksTheGeometricallyRightOne) {
    const TriangleMesh mesh = make_icosphere(2);
    const test::DisguisedMesh target = test::shuffled(mesh, 5);
    const ExactResult result = match_exact(mesh, target.mesh);
    expect_isomorphism(mesh, target.mesh, result);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);  // as it lies, of 60 that fit as well
    EXPECT_EQ(result.automorphisms.number, 60U);
    EXPECT_EQ(result.mirror_automorphisms.number, 60U);
    // With one vertex pulled out, only one of the rotations keeps the lengths, whatever the pose.
    TriangleMesh spiked = mesh;
    spiked.vertices.row(77) *= 1.5;
    spiked.vertices.row(5) *= 1.2;
    const test::DisguisedMesh moved = test::shuffled(test::moved(spiked, 2), 5);
    EXPECT_EQ(match_exact(spiked, moved.mesh).target_from_source, moved.mesh_from_original);
}

TEST(MatchExact, CountsTheSymmetriesOfATorus) {
    // Translations of a triangular lattice on 8 x 13: the half turn is an automorphism, sixths of a turn are
    // not.
    TriangleMesh mesh = make_torus(8, 13);
    const ExactResult result = match_exact(mesh, test::shuffled(mesh, 6).mesh);
    EXPECT_EQ(result.automorphisms.number, 2U * 8U * 13U);
    // Stretched on one side, only one of them keeps the lengths.
    for (Index v = 0; v < mesh.n_vertices(); ++v) mesh.vertices.row(v) *= 1 + 0.1 * std::sin(0.37 * v);
    const test::DisguisedMesh target = test::shuffled(test::moved(mesh, 1), 6);
    EXPECT_EQ(match_exact(mesh, target.mesh).target_from_source, target.mesh_from_original);
}

TEST(MatchExact, PairsEqualIslandsByPosition) {
    TriangleMesh mesh = lopsided();
    for (int i = 0; i < 5; ++i) {
        TriangleMesh island = make_icosphere(0);
        island.vertices *= 0.1;
        island.vertices.rowwise() += Eigen::RowVector3d(1.5 + 0.3 * i, 0.1 * i * i, 0.2 * i);
        mesh = test::joined(mesh, island);
    }
    const test::DisguisedMesh target = test::shuffled(test::moved(mesh, 8), 9);
    const ExactResult result = match_exact(mesh, target.mesh);
    expect_isomorphism(mesh, target.mesh, result);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    ASSERT_EQ(result.interchangeable.size(), 1U);
    EXPECT_EQ(result.interchangeable[0].source.size(), 5U);
    EXPECT_EQ(result.automorphisms.number, 120ULL * 60 * 60 * 60 * 60 * 60);
}

TEST(MatchExact, MatchesReversedWindingAndSaysSo) {
    const TriangleMesh mesh = lopsided();
    const test::DisguisedMesh target = test::shuffled(mesh, 10);
    const TriangleMesh reversed = with_reversed_winding(target.mesh, 1);
    const ExactResult whole = match_exact(mesh, reversed);
    expect_isomorphism(mesh, reversed, whole);
    EXPECT_EQ(whole.target_from_source, target.mesh_from_original);
    EXPECT_TRUE(whole.winding_reversed);
    const TriangleMesh some = with_reversed_winding(target.mesh, 10);
    const ExactResult tenth = match_exact(mesh, some);
    expect_isomorphism(mesh, some, tenth);
    EXPECT_EQ(tenth.target_from_source, target.mesh_from_original);
    EXPECT_EQ(tenth.reversed_triangles, 128);
    EXPECT_FALSE(tenth.winding_reversed);
}

TEST(MatchExact, MatchesAMoebiusBand) {
    TriangleMesh band = make_grid(12, 2);
    // The right end glued to the left one upside down.
    std::vector<Index> name(static_cast<std::size_t>(band.n_vertices()));
    for (Index v = 0; v < band.n_vertices(); ++v)
        name[static_cast<std::size_t>(v)] = v % 13 == 12 ? (2 - v / 13) * 13 : v;
    for (Index t = 0; t < band.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            band.triangles(t, c) = name[static_cast<std::size_t>(band.triangles(t, c))];
    const test::DisguisedMesh target = test::shuffled(band, 2);
    expect_isomorphism(band, target.mesh, match_exact(band, target.mesh));
}

TEST(MatchExact, MatchesAcrossNonManifoldEdges) {
    // A third sheet on an edge of the surface, and a copy of a face.
    TriangleMesh mesh = lopsided();
    const Index n = mesh.n_vertices(), m = mesh.n_triangles();
    mesh.vertices.conservativeResize(n + 1, 3);
    mesh.vertices.row(n) << 2, 0, 0;
    mesh.triangles.conservativeResize(m + 2, 3);
    mesh.triangles.row(m) << mesh.triangles(5, 0), mesh.triangles(5, 1), n;
    mesh.triangles.row(m + 1) = mesh.triangles.row(100);
    const test::DisguisedMesh target = test::shuffled(test::moved(mesh, 3), 11);
    const ExactResult result = match_exact(mesh, target.mesh);
    expect_isomorphism(mesh, target.mesh, result);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.path, ExactPath::patches);
    EXPECT_EQ(result.automorphisms.number, 2U);  // the two copies of the face
}

TEST(MatchExact, NamesADifference) {
    const TriangleMesh mesh = lopsided();
    const ExactResult flipped = match_exact(mesh, test::with_flipped_edges(mesh, 1, 3).mesh);
    EXPECT_FALSE(flipped.identical);
    EXPECT_NE(flipped.difference.find("no source component has the connectivity of the target component"),
              std::string::npos)
        << flipped.difference;
    EXPECT_NE(flipped.difference.find("(1280 triangles)"), std::string::npos) << flipped.difference;
    // A torus of other rings has as many vertices and triangles, all alike.
    const ExactResult torus = match_exact(make_torus(6, 8), make_torus(4, 12));
    EXPECT_FALSE(torus.identical);
    EXPECT_NE(torus.difference.find("(96 triangles)"), std::string::npos) << torus.difference;
    EXPECT_EQ(match_exact(make_grid(3, 3), make_torus(3, 3)).difference,
              "the source has 16 vertices with triangles, the target 9");
    const TriangleMesh ball = make_icosphere(0), two = test::joined(ball, lopsided()),
                       three = test::joined(two, ball);
    EXPECT_EQ(match_exact(test::joined(two, lopsided()), test::joined(two, two)).difference,
              "the source has 2580 triangles, the target 2600");
    EXPECT_FALSE(match_exact(three, test::joined(two, make_icosphere(0))).difference.size());
}

TEST(MatchExact, SaysTheSameOfManyClassesInOneNotice) {
    TriangleMesh mesh = make_torus(3, 3);
    for (int n = 3; n < 12; ++n) {
        for (int i = 0; i < 2; ++i) {
            TriangleMesh torus = make_torus(3, n);
            torus.vertices.rowwise() += Eigen::RowVector3d(20 * n, 20 * i, 3 * i);
            mesh = test::joined(mesh, torus);
        }
    }
    const test::DisguisedMesh target = test::shuffled(mesh, 5);
    const ExactResult result = match_exact(mesh, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.interchangeable.size(), 9U);
    EXPECT_LE(result.messages.size(), 3U);
}

TEST(MatchExact, TellsAPeriodicPatternWithOneDefect) {
    // Every tenth ring of a long tube has a flipped edge; once it is the eleventh. Each of the thousand looks
    // alike from nearby.
    TriangleMesh tube = make_torus(10'000, 6);
    const auto flip = [&](Index ring) {
        // The two triangles of one square: exchange its diagonal.
        const Index t = 12 * ring, u = t + 1;
        std::array<Index, 4> corners{};
        std::size_t n = 0;
        for (int c = 0; c < 3; ++c) corners[n++] = tube.triangles(t, c);
        for (int c = 0; c < 3; ++c)
            if (std::find(corners.begin(), corners.begin() + 3, tube.triangles(u, c)) == corners.begin() + 3)
                corners[3] = tube.triangles(u, c);
        for (int c = 0; c < 3; ++c) {
            const Index apex = tube.triangles(t, c), a = tube.triangles(t, (c + 1) % 3),
                        b = tube.triangles(t, (c + 2) % 3);
            bool shared_a = false, shared_b = false;
            for (int d = 0; d < 3; ++d) {
                shared_a = shared_a || tube.triangles(u, d) == a;
                shared_b = shared_b || tube.triangles(u, d) == b;
            }
            if (!shared_a || !shared_b) continue;
            tube.triangles.row(t) << apex, a, corners[3];
            tube.triangles.row(u) << apex, corners[3], b;
            return;
        }
    };
    for (Index ring = 0; ring + 10 < 10'000; ring += 10) flip(ring == 5'000 ? ring + 1 : ring);
    const test::DisguisedMesh target = test::shuffled(tube, 3);
    const ExactResult result = match_exact(tube, target.mesh);
    expect_isomorphism(tube, target.mesh, result);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.automorphisms.number, 1U);
}

TEST(MatchExact, ReportsProgressAndStops) {
    const TriangleMesh mesh = lopsided();
    const test::DisguisedMesh target = test::shuffled(mesh, 5);
    ExactOptions options;
    std::vector<double> seen;
    options.progress = [&](double share) { return seen.push_back(share), true; };
    match_exact(mesh, target.mesh, options);
    ASSERT_FALSE(seen.empty());
    EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
    EXPECT_EQ(seen.back(), 1);
    for (const double end : seen) {
        options.progress = [&](double share) { return share < end; };
        EXPECT_THROW(match_exact(mesh, target.mesh, options), Canceled);
    }
}

TEST(MatchExact, WeldsDuplicatesAndFindsAPartnerForEach) {
    const TriangleMesh soup = test::with_separate_triangles(lopsided());
    const test::DisguisedMesh target = test::shuffled(soup, 12);
    ExactOptions options;
    options.weld_distance = 0;
    const ExactResult result = match_exact(soup, target.mesh, options);
    ASSERT_TRUE(result.identical);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.automorphisms.number, 1U);
}

TEST(MatchExact, WeldsSeparateTrianglesUnasked) {
    const TriangleMesh body = make_body({.subdivisions = 1}), source = test::with_separate_triangles(body);
    const TriangleMesh bent = deform(body, {.bend = 0.9, .twist = 0.4});
    const test::DisguisedMesh target = test::shuffled(test::with_separate_triangles(bent), 12);
    const ExactResult result = match_exact(source, target.mesh);
    ASSERT_TRUE(result.identical) << result.difference;
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_TRUE(contains(result.messages, MessageCode::welded));
    EXPECT_TRUE(result.by_place.empty());

    const TriangleMesh finer = test::with_separate_triangles(subdivide(bent));
    const ExactResult other = match_exact(source, finer);
    EXPECT_FALSE(other.identical);
    EXPECT_NE(other.difference.find(std::to_string(source.n_vertices()) + " -> " +
                                    std::to_string(body.n_vertices())),
              std::string::npos)
        << other.difference;
}

TEST(MatchExact, LeavesTrianglesThatAreApart) {
    Random random(3);
    TriangleMesh leaves = test::with_separate_triangles(make_icosphere(2));
    for (double& x : leaves.vertices.reshaped()) x += random.uniform(0, 0.01);
    const test::DisguisedMesh target = test::shuffled(leaves, 12);
    const ExactResult result = match_exact(leaves, target.mesh);
    ASSERT_TRUE(result.identical);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_FALSE(contains(result.messages, MessageCode::welded));
}

TEST(MatchExact, GivesTheOtherMatchesOfASymmetricMesh) {
    const TriangleMesh mesh = make_icosphere(0);
    ExactOptions options;
    options.max_alternatives = 1000;
    const ExactResult result = match_exact(mesh, mesh, options);
    EXPECT_EQ(result.alternatives.size(), 60U);  // 59 rotations and the mirror image
    for (const VertexMap& other : result.alternatives) EXPECT_NE(other, result.target_from_source);
}

TEST(MatchExact, MatchesTenThousandTetrahedra) {
    Random random(1);
    constexpr Index n = 10'000;
    TriangleMesh mesh{Points(4 * n, 3), Triangles(4 * n, 3)};
    for (Index i = 0; i < n; ++i) {
        const Eigen::RowVector3d at(random.uniform(0, 100), random.uniform(0, 100), random.uniform(0, 100));
        mesh.vertices.row(4 * i) = at;
        mesh.vertices.row(4 * i + 1) = at + Eigen::RowVector3d(1, 0, 0);
        mesh.vertices.row(4 * i + 2) = at + Eigen::RowVector3d(0, 1, 0);
        mesh.vertices.row(4 * i + 3) = at + Eigen::RowVector3d(0, 0, 1);
        const Index a = 4 * i;
        mesh.triangles.row(4 * i) << a, a + 2, a + 1;
        mesh.triangles.row(4 * i + 1) << a, a + 1, a + 3;
        mesh.triangles.row(4 * i + 2) << a, a + 3, a + 2;
        mesh.triangles.row(4 * i + 3) << a + 1, a + 2, a + 3;
    }
    const test::DisguisedMesh target = test::shuffled(mesh, 13);
    const ExactResult result = match_exact(mesh, target.mesh);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_FALSE(result.automorphisms.number.has_value());
    EXPECT_NEAR(result.automorphisms.log10, 35659.45 + n * std::log10(12.0), 1);
}

// A seam that is open in one mesh only: both sides lie where the other's one vertex lies, which is no
// isomorphism.
TEST(MatchExact, ASeamOpenInOneMeshOnlyIsADifference) {
    const TriangleMesh body = make_body({.subdivisions = 1});
    TriangleMesh open = body;
    open.vertices.conservativeResize(body.n_vertices() + 1, 3);
    open.vertices.row(body.n_vertices()) = body.vertices.row(body.triangles(0, 0));
    open.triangles(0, 0) = body.n_vertices();
    EXPECT_FALSE(match_exact(open, body).identical);
    EXPECT_FALSE(match_exact(body, open).identical);
}

}  // namespace
}  // namespace counterpart
