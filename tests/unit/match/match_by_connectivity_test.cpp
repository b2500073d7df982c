// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// How `automatic` matches meshes whose connectivity is the same, nearly the same, or the same in a part.
#include "support/cuts.hpp"
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/quick_match.hpp"

#include <counterpart/map/invert.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/mesh/weld.hpp>

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::count_unmatched;
using test::expect_part;
using test::quick;

TEST(Match, SameConnectivityIsExact) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const test::DisguisedMesh target = test::posed(source);
    const MatchResult result = match(source, target.mesh);
    EXPECT_EQ(result.method, MatchMethod::exact);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    EXPECT_EQ(result.confidence, Vector::Ones(source.n_vertices()));
    EXPECT_EQ(result.reason, "the meshes have the same connectivity");
    EXPECT_EQ(result.n_filled, 0);
    ASSERT_TRUE(result.exact.has_value());
    EXPECT_TRUE(result.exact->identical);
    EXPECT_FALSE(result.differences.has_value());
    EXPECT_FALSE(result.spectral.has_value());
    ASSERT_FALSE(result.stages.empty());
    EXPECT_EQ(result.stages[0].stage, "exact");
}

TEST(Match, SeparateTrianglesOfTheSameSurfaceAreExact) {
    const TriangleMesh body = make_body({.subdivisions = 1}), source = test::with_separate_triangles(body);
    const TriangleMesh bent = deform(body, {.bend = 0.9, .twist = 0.4});
    const test::DisguisedMesh target = test::shuffled(test::with_separate_triangles(bent), 5);
    for (const MatchMethod method : {MatchMethod::automatic, MatchMethod::exact}) {
        MatchOptions options;
        options.method = method;
        const MatchResult result = match(source, target.mesh, options);
        EXPECT_EQ(result.method, MatchMethod::exact);
        EXPECT_EQ(result.target_from_source, target.mesh_from_original);
        EXPECT_TRUE(contains(result.messages, MessageCode::welded));
    }
    EXPECT_EQ(match(source, bent).method, MatchMethod::exact);
}

TEST(Match, SeparateTrianglesShowNothingByTheirConnectivity) {
    const TriangleMesh body = make_body({.subdivisions = 0}), source = test::with_separate_triangles(body);
    const TriangleMesh finer = subdivide(deform(body, {.bend = 0.5}));
    const TriangleMesh target = test::with_separate_triangles(finer);
    const MatchResult result = match(source, target, quick());
    EXPECT_EQ(result.method, MatchMethod::spectral) << result.reason;
    const double limit = 0.1 * std::sqrt(surface_area(finer));
    Index n_near = 0;
    for (Index t = 0; t < body.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)  // the vertices of the coarse mesh are the first of the finer one
            n_near += (target.vertices.row(result.target_from_source[3 * t + c]) -
                       finer.vertices.row(body.triangles(t, c)))
                                  .norm() < limit
                          ? 1
                          : 0;
    EXPECT_GT(n_near, 0.9 * source.n_vertices());

    const MatchResult shared = match(source, target, quick(MatchMethod::exact));
    EXPECT_LE(shared.confidence.maxCoeff(), 0.5);
    EXPECT_EQ(verdict(shared).advice, Advice::check) << result.reason;
}

TEST(Match, AFlippedEdgeLeavesTheRestExact) {
    const TriangleMesh source = make_body({.subdivisions = 2});
    const test::DisguisedMesh target = test::posed(test::with_flipped_edges(source, 1, 21).mesh);
    const MatchResult result = match(source, target.mesh);
    EXPECT_EQ(result.method, MatchMethod::exact);
    EXPECT_EQ(result.target_from_source, target.mesh_from_original);
    expect_part(result.reason, "nearly the same connectivity");
    ASSERT_TRUE(result.exact.has_value());
    EXPECT_FALSE(result.exact->identical);
    ASSERT_TRUE(result.differences.has_value());
    expect_part(result.reason, result.differences->summary);
    EXPECT_EQ(result.n_filled, count_unmatched(result.differences->target_from_source));
    EXPECT_EQ((result.confidence.array() == 0).count(), result.n_filled);
    EXPECT_GT((result.confidence.array() == 1).count(), 0.99 * source.n_vertices());
    EXPECT_FALSE(result.spectral.has_value());
}

// Connectivity decides also where one mesh lacks most of the other: exact where partial matching slides.
TEST(Match, APartInOtherNumbersIsExactInBothDirections) {
    const TriangleMesh whole = make_body({.subdivisions = 2});
    const test::PartOfMesh part = test::cut_by_plane(whole, {0.2, 1, 0.1}, whole.vertices.col(1).mean());
    const test::DisguisedMesh other = test::posed(deform(part.mesh, {.bend = 0.4}));
    const VertexMap truth = compose_maps(invert(other.mesh_from_original), part.whole_from_part);
    const MatchResult there = match(other.mesh, whole), back = match(whole, other.mesh);
    for (const MatchResult* result : {&there, &back}) {
        EXPECT_EQ(result->method, MatchMethod::exact);
        expect_part(result->reason, "is a part of the other's");
    }
    Index wrong = 0, invented = 0;
    const VertexMap part_from_whole = invert(truth);
    for (Index v = 0; v < truth.source_size(); ++v)
        if (there.target_from_source[v] != truth[v]) ++wrong;
    for (Index v = 0; v < whole.n_vertices(); ++v)
        if (back.target_from_source[v] != part_from_whole[v]) ++invented;
    EXPECT_LE(wrong, truth.source_size() / 100);
    EXPECT_LE(invented, whole.n_vertices() / 100);
    EXPECT_LT(count_matched(back.target_from_source), 0.7 * whole.n_vertices());
}

// Both shares are above min_shared then; what was cut off is no gap to be filled.
TEST(Match, ASmallPieceThatIsMissingStaysUnmatched) {
    const TriangleMesh whole = make_body({.subdivisions = 2});
    std::vector<double> heights(whole.vertices.col(1).begin(), whole.vertices.col(1).end());
    std::sort(heights.begin(), heights.end());
    const test::PartOfMesh part = test::cut_by_plane(whole, {0, 1, 0}, heights[heights.size() / 20]);
    const test::DisguisedMesh other = test::posed(deform(part.mesh, {.bend = 0.4}));
    const VertexMap truth = compose_maps(invert(part.whole_from_part), other.mesh_from_original);
    const MatchResult result = match(whole, other.mesh);
    EXPECT_EQ(result.method, MatchMethod::exact);
    Index n_missing = 0;
    for (Index v = 0; v < whole.n_vertices(); ++v) {
        if (truth[v] != VertexMap::unmatched) continue;
        ++n_missing;
        EXPECT_EQ(result.target_from_source[v], VertexMap::unmatched) << v;
    }
    EXPECT_GT(n_missing, whole.n_vertices() / 50);
}

TEST(Match, ARemovedVertexFollowsThoseAroundIt) {
    const TriangleMesh source = make_body({.subdivisions = 2});
    const test::EditedMesh edited = test::without_vertex(source, 3);
    const test::DisguisedMesh target = test::posed(edited.mesh);
    const MatchResult result = match(source, target.mesh);
    EXPECT_EQ(result.method, MatchMethod::exact);
    expect_part(result.reason, "nearly the same connectivity");
    EXPECT_EQ(count_unmatched(result.target_from_source), 0);
    ASSERT_TRUE(result.differences.has_value());
    EXPECT_EQ(result.n_filled, count_unmatched(result.differences->target_from_source));
    EXPECT_GE(result.n_filled, 1);

    Index removed = -1, right = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index now = edited.edited_from_original[static_cast<std::size_t>(v)];
        if (now < 0) {
            removed = v;
            continue;
        }
        const bool is_right = result.target_from_source[v] == target.mesh_from_original[now];
        right += is_right ? 1 : 0;
        EXPECT_TRUE(is_right || result.confidence[v] < 1) << "vertex " << v << " is wrong";
    }
    EXPECT_GE(right, 0.999 * (source.n_vertices() - 1));
    ASSERT_GE(removed, 0);
    EXPECT_EQ(result.confidence[removed], 0);
    std::set<Index> images_of_ring;
    for (const Index t : edited.changed) {
        for (int c = 0; c < 3; ++c) {
            const Index now = edited.edited_from_original[static_cast<std::size_t>(source.triangles(t, c))];
            if (now >= 0) images_of_ring.insert(target.mesh_from_original[now]);
        }
    }
    EXPECT_TRUE(images_of_ring.contains(result.target_from_source[removed]));
    EXPECT_EQ((result.confidence.array() == 0).count(), result.n_filled);
}

TEST(Match, WhereTheVertexIsTheTargetsNothingIsFilled) {
    const TriangleMesh target = make_body({.subdivisions = 2});
    const test::EditedMesh edited = test::without_vertex(target, 3);
    const MatchResult result = match(edited.mesh, target);
    EXPECT_EQ(result.method, MatchMethod::exact);
    EXPECT_EQ(count_unmatched(result.target_from_source), 0);
    for (Index v = 0; v < target.n_vertices(); ++v) {
        const Index now = edited.edited_from_original[static_cast<std::size_t>(v)];
        if (now >= 0) {
            EXPECT_EQ(result.target_from_source[now], v);
        }
    }
}

TEST(Match, MinSharedDecidesWhatIsNearlyTheSame) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const test::DisguisedMesh target = test::posed(test::without_vertex(source, 3).mesh);
    MatchOptions options = quick();
    options.min_shared = 1;  // one vertex of the source has no partner
    const MatchResult result = match(source, target.mesh, options);
    EXPECT_EQ(result.method, MatchMethod::spectral);
    expect_part(result.reason, "the connectivity differs: ");
    EXPECT_TRUE(result.differences.has_value());
    EXPECT_EQ(result.n_filled, 0);
}

// The same mesh below, other triangles above.
TriangleMesh with_other_triangles_above(const TriangleMesh& mesh, double height) {
    std::vector<Index> above, below;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        (mesh.vertices(mesh.triangles(t, 0), 1) > height ? above : below).push_back(t);
    const TriangleMesh upper{mesh.vertices, mesh.triangles(above, Eigen::all)},
        lower{mesh.vertices, mesh.triangles(below, Eigen::all)};
    return weld(test::joined(lower, retriangulate(upper, {.kept_share = 0.7}).mesh)).mesh;
}

// What connectivity finds leads the rest, unless the map without it scores better; either is right.
TEST(Match, WhatConnectivityFindsLeadsWhereThatIsBetter) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const double height = source.vertices.col(1).mean();
    const TriangleMesh other = with_other_triangles_above(source, height);
    const test::DisguisedMesh target = test::posed(other);
    const MatchResult result = match(source, target.mesh, quick());
    EXPECT_EQ(result.method, MatchMethod::spectral);
    ASSERT_TRUE(result.differences.has_value());
    EXPECT_GT(result.differences->source_share, 0.3);
    const VertexMap original = invert(target.mesh_from_original);
    double sum = 0;
    for (Index v = 0; v < source.n_vertices(); ++v)
        sum += (other.vertices.row(original[result.target_from_source[v]]) - source.vertices.row(v)).norm();
    EXPECT_LT(100 * sum / source.n_vertices() / std::sqrt(surface_area(source)), 2);
    const SpectralResult free = match_spectral(source, target.mesh, {}, quick().spectral_shape);
    EXPECT_GE(result.spectral->score, free.score);
    const bool kept = result.reason.find("these are kept") != std::string::npos;
    EXPECT_EQ(kept, result.spectral->score > free.score) << result.reason;
}

}  // namespace
}  // namespace counterpart
