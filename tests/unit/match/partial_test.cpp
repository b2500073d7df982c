// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/tears.hpp"
#include "support/cuts.hpp"
#include "support/disguise.hpp"
#include "support/expect_error.hpp"
#include "support/messages.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/partial.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

// Few samples: the bodies are small.
const PartialOptions known{.same_scale = true, .n_samples = 300};

// A body in two poses and two triangulations. Positions in the rest pose tell how far a vertex is from where
// it belongs.
class MatchPartial : public testing::Test {
  protected:
    const TriangleMesh whole = make_body({.subdivisions = 1});
    const TriangleMesh other_rest = make_body({.subdivisions = 2});
    const TriangleMesh other = deform(other_rest, {.bend = 0.4, .twist = 0.3});
    const double length = std::sqrt(surface_area(whole));

    // Mean over matched vertices of `part`, which came from `whole`, x 100 / sqrt(area).
    double error(const VertexMap& map, const VertexMap& whole_from_part) const {
        double sum = 0;
        for (Index v = 0; v < map.source_size(); ++v)
            if (map[v] >= 0)
                sum += (whole.vertices.row(whole_from_part[v]) - other_rest.vertices.row(map[v])).norm();
        return 100 * sum / count_matched(map) / length;
    }
    test::PartOfMesh upper() const { return test::cut_by_plane(whole, {0.2, 1, 0.1}, middle()); }
    double middle() const { return whole.vertices.col(1).mean() - 0.1; }
};

TEST_F(MatchPartial, RefusesBadInput) {
    EXPECT_THROW(match_partial({}, whole), InvalidInput);
    EXPECT_THROW(match_partial(make_icosphere(1), whole), UnsuitableMesh);  // 42 vertices
    EXPECT_THROW(match_partial(whole, make_icosphere(1)), UnsuitableMesh);
    TriangleMesh flat = whole;
    flat.vertices.setZero();
    EXPECT_THROW(match_partial(flat, whole), UnsuitableMesh);
    EXPECT_THROW(match_partial(whole, whole, {.landmarks = {{0, whole.n_vertices()}}}), InvalidInput);
    EXPECT_THROW(match_partial(whole, whole, {.n_samples = 100}), InvalidInput);
    EXPECT_THROW(match_partial(whole, whole, {.n_alternatives = -1}), InvalidInput);
    EXPECT_THROW(match_partial(whole, whole, {.n_threads = -1}), InvalidInput);
}

// More would take memory without bound: distances from each to all vertices, and agreement of all with all.
TEST_F(MatchPartial, RefusesMoreLandmarksThanItHasMemoryFor) {
    const std::vector<std::pair<Index, Index>> pairs(800, {0, 0});
    const auto refused = [&](PartialOptions options, std::size_t n_pairs) {
        options.n_samples = 5000;
        options.landmarks = std::vector(n_pairs, std::pair<Index, Index>(0, 0));
        test::expect_error<InvalidInput>([&] { match_partial(whole, whole, options); }, "give at most 750");
    };
    refused({}, 751);
    refused({.part = Part::neither}, 751);
    test::expect_error<InvalidInput>(
        [&] { match_partial(whole, whole, {.excluded = pairs, .n_samples = 5000}); }, "800 excluded pairs");
    const TriangleMesh fine = make_grid(300, 300);
    test::expect_error<UnsuitableMesh>(
        [&] { match_partial(fine, whole, {.part = Part::source, .n_samples = 5000}); },
        "simplify it to at most 90000");
    test::expect_error<UnsuitableMesh>(
        [&] {
            match_partial(whole, fine,
                          {.part = Part::source, .landmarks = {{0, 0}, {5, 5}}, .n_samples = 4998});
        },
        "from 5000 samples and landmarks");
}

TEST_F(MatchPartial, CutBodyLandsOnTheWholeInAnotherPose) {
    const test::PartOfMesh part = upper();
    const PartialResult result = match_partial(part.mesh, other, known);
    EXPECT_EQ(result.part, Part::source);
    EXPECT_EQ(count_matched(result.target_from_source), part.mesh.n_vertices());
    EXPECT_LT(error(result.target_from_source, part.whole_from_part), 1.55);  // unfinished: 1.61
    EXPECT_GT(result.confidence.mean(), 0.5);
    EXPECT_NEAR(result.target_share, surface_area(part.mesh) / surface_area(whole), 0.1);
}

TEST_F(MatchPartial, WholeToPartLeavesTheRestUnmatched) {
    const test::PartOfMesh part = upper();
    const PartialResult there = match_partial(part.mesh, other, known),
                        back = match_partial(other, part.mesh, known);
    EXPECT_EQ(back.part, Part::target);
    EXPECT_EQ(back.target_from_source, there.source_from_target);
    EXPECT_EQ(back.source_from_target, there.target_from_source);
    Index missed = 0, invented = 0;
    for (Index v = 0; v < other.n_vertices(); ++v) {
        const double side = other_rest.vertices.row(v).dot(Eigen::RowVector3d(0.2, 1, 0.1)) - middle();
        if (back.target_from_source[v] < 0 && side > 0.15 * length) ++missed;
        if (back.target_from_source[v] >= 0 && side < -0.15 * length) ++invented;
    }
    EXPECT_LT(missed, other.n_vertices() / 20);
    EXPECT_LT(invented, other.n_vertices() / 20);
}

TEST_F(MatchPartial, MovedRenumberedAndOfUnknownScale) {
    const test::PartOfMesh part = upper();
    const double before =
        error(match_partial(part.mesh, other, known).target_from_source, part.whole_from_part);
    const test::DisguisedMesh disguised = test::shuffled(test::moved(part.mesh, 4), 5);  // scaled, too
    const PartialResult result = match_partial(disguised.mesh, other, {.n_samples = 300});
    const double true_scale = std::sqrt(surface_area(part.mesh) / surface_area(disguised.mesh));
    EXPECT_NEAR(result.scale / true_scale, 1, 0.15);
    EXPECT_LT(
        error(compose_maps(disguised.mesh_from_original, result.target_from_source), part.whole_from_part),
        before + 2);
}

TEST_F(MatchPartial, PartsThatOverlap) {
    const test::PartOfMesh a = upper();
    const test::PartOfMesh b = test::part_of(other, [&](const Eigen::RowVector3d& x) {
        return x[1] < other.vertices.col(1).mean() + 0.35 * length;
    });
    const PartialResult result = match_partial(a.mesh, b.mesh, known);
    EXPECT_EQ(result.part, Part::both);
    EXPECT_GT(count_matched(result.target_from_source), 0);
    EXPECT_LT(count_matched(result.target_from_source), a.mesh.n_vertices());
    const VertexMap on_other = compose_maps(result.target_from_source, b.whole_from_part);
    EXPECT_LT(error(on_other, a.whole_from_part), 1.75);  // unfinished: 2.11
    EXPECT_EQ(match_partial(b.mesh, a.mesh, known).source_from_target, result.target_from_source);
    PartialOptions in_mirror = known;
    in_mirror.mirrored = true;
    const PartialResult back = match_partial(a.mesh, test::mirrored(b.mesh), in_mirror);
    EXPECT_LT(result.gain_in_mirror, -0.005);
    EXPECT_NEAR(back.gain_in_mirror, -result.gain_in_mirror, 0.005);
}

TEST_F(MatchPartial, TwoThatShowTheSameRegionAreWhole) {
    const double knees = whole.vertices.col(1).mean() - 0.5 * length;
    const test::PartOfMesh a = test::cut_by_plane(whole, {0, 1, 0}, knees);
    test::PartOfMesh b = test::cut_by_plane(other_rest, {0, 1, 0}, knees);
    b.mesh.vertices = other.vertices(b.whole_from_part.image(), Eigen::all);
    const PartialResult result = match_partial(a.mesh, b.mesh, known);
    EXPECT_EQ(result.part, Part::neither);
    EXPECT_EQ(count_matched(result.target_from_source), a.mesh.n_vertices());
    const VertexMap on_other = compose_maps(result.target_from_source, b.whole_from_part);
    EXPECT_LT(error(on_other, a.whole_from_part), 1.5);
    PartialOptions as_parts = known;
    as_parts.part = Part::both;
    EXPECT_EQ(match_partial(a.mesh, b.mesh, as_parts).part, Part::both);
}

TEST_F(MatchPartial, PartsThatDoNotOverlapAreDoubted) {
    const double knees = whole.vertices.col(1).mean() - 0.15 * length;
    const test::PartOfMesh top = upper(), legs = test::cut_by_plane(whole, {0, -1, 0}, -knees);
    const PartialResult result = match_partial(legs.mesh, top.mesh, known);
    EXPECT_EQ(result.part, Part::both);
    EXPECT_LT(result.confidence.mean(), 0.2);
    EXPECT_TRUE(contains(result.messages, MessageCode::misfit)) << test::lines_of(result.messages);
}

TEST_F(MatchPartial, HolesAreMatchedAround) {
    const test::PartOfMesh part = test::with_holes(whole, 5, 0.12 * length, 3);
    const PartialResult result = match_partial(part.mesh, other, {.same_scale = true, .n_samples = 600});
    EXPECT_LT(error(result.target_from_source, part.whole_from_part), 2.2);  // unfinished: 2.37
}

TEST_F(MatchPartial, LandmarksAreKept) {
    const test::PartOfMesh part = upper();
    const PartialResult free = match_partial(part.mesh, other, known);
    PartialOptions options = known;
    for (const Index v : {10, 200, 400}) options.landmarks.emplace_back(v, free.target_from_source[v]);
    options.landmarks[1].second = free.target_from_source[201];  // near, not where the surface would go
    const PartialResult result = match_partial(part.mesh, other, options);
    EXPECT_LT(error(result.target_from_source, part.whole_from_part), 2);
    for (const auto& [on_part, on_whole] : options.landmarks) {
        EXPECT_EQ(result.target_from_source[on_part], on_whole);
        EXPECT_EQ(result.source_from_target[on_whole], on_part);
    }
    options.soft_landmarks = true;
    EXPECT_NE(match_partial(part.mesh, other, options).target_from_source[options.landmarks[1].first],
              options.landmarks[1].second);
}

TEST_F(MatchPartial, UnlikeShapesAndWrongScalesAreDoubted) {
    const test::PartOfMesh part = upper();
    const PartialResult unlike =
        match_partial(part.mesh, make_torus(40, 60), {.part = Part::source, .n_samples = 300});
    EXPECT_LT(unlike.confidence.mean(), 0.4);
    EXPECT_NE(gravest(unlike.messages), Severity::notice);
    for (const double factor : {0.1, 10.0}) {
        TriangleMesh wrong = part.mesh;
        wrong.vertices *= factor;
        const PartialResult result = match_partial(wrong, other, known);
        EXPECT_LT(result.confidence.mean(), 0.4) << factor;
        EXPECT_NE(gravest(result.messages), Severity::notice);
    }
}

// Half an egg: at some scale it looks a little like a part of the body.
TEST_F(MatchPartial, WhatFitsALittleIsUnsure) {
    TriangleMesh egg = make_icosphere(3);
    egg.vertices = egg.vertices * Eigen::Vector3d(0.6, 0.3, 0.9).asDiagonal();
    const test::PartOfMesh half = test::cut_by_plane(egg, {1, 0, 0}, 0.1);
    const PartialResult result = match_partial(half.mesh, whole, {.part = Part::source, .n_samples = 300});
    EXPECT_LT(result.confidence.mean(), 0.4);
    EXPECT_NE(gravest(result.messages), Severity::notice) << test::lines_of(result.messages);
}

// Bent until its foot is in its head's way, and grown together there.
TEST_F(MatchPartial, AFusedBodyIsMatchedAndWhereItTouchesIsSuspected) {
    const double radian = std::acos(-1) / 180;
    const FusedMesh fused =
        fuse(deform(other_rest, {.bend = 360 * radian, .twist = 100 * radian}), 0.03 * length);
    const PartialResult result = match_partial(fused.mesh, whole, {.part = Part::neither, .n_samples = 300});
    EXPECT_EQ(count_matched(result.target_from_source), fused.mesh.n_vertices());
    double sum = 0;
    int n = 0;
    for (Index v = 0; v < other_rest.n_vertices(); ++v) {
        const Index own = fused.fused_from_original[static_cast<std::size_t>(v)];
        if (own < 0) continue;
        sum += (other_rest.vertices.row(v) - whole.vertices.row(result.target_from_source[own])).norm();
        ++n;
    }
    EXPECT_LT(100 * sum / n / length, 10);  // where it touches its twisted limbs are stretched
    const auto n_touching = static_cast<double>(result.source_touching.size());
    EXPECT_GT(n_touching, 0.001 * fused.mesh.n_vertices());
    EXPECT_LT(n_touching, 0.1 * fused.mesh.n_vertices());
}

TEST_F(MatchPartial, TornVerticesAreThoseWhoseNeighborsGoElsewhere) {
    const TriangleMesh sheet = make_grid(20, 20);
    const double unit = std::sqrt(surface_area(sheet));
    Points places = sheet.vertices / unit;
    EXPECT_TRUE(surface_match::torn_vertices(sheet, places).empty());
    EXPECT_TRUE(surface_match::torn_vertices(sheet, 2 * places).empty());
    places.row(210) += Eigen::RowVector3d(0, 0, 0.5);  // inside: it and the four around it
    const std::vector<Index> torn = surface_match::torn_vertices(sheet, places);
    EXPECT_EQ(torn.size(), 5U);
    EXPECT_TRUE(std::binary_search(torn.begin(), torn.end(), 210));
}

TEST_F(MatchPartial, DoesNotDependOnThreads) {
    const test::PartOfMesh part = upper();
    const PartialResult one = match_partial(part.mesh, whole,
                                            {.same_scale = true, .n_samples = 300, .n_threads = 1}),
                        three = match_partial(part.mesh, whole,
                                              {.same_scale = true, .n_samples = 300, .n_threads = 3});
    EXPECT_EQ(one.target_from_source, three.target_from_source);
    EXPECT_EQ(one.confidence, three.confidence);
}

TEST_F(MatchPartial, ReportsProgressAndCancels) {
    const test::PartOfMesh part = upper();
    double last = 0;
    match_partial(part.mesh, whole, {.same_scale = true, .n_samples = 300, .progress = [&](double fraction) {
                                         EXPECT_GE(fraction, last);
                                         last = fraction;
                                         return true;
                                     }});
    EXPECT_EQ(last, 1);
    EXPECT_THROW(match_partial(part.mesh, whole, {.progress = [](double) { return false; }}), Canceled);
}

TEST_F(MatchPartial, IsTakenByAutomaticForOpenMeshes) {
    const MatchResult result = match(upper().mesh, other, {.partial = known});
    EXPECT_EQ(result.method, MatchMethod::partial);
    ASSERT_TRUE(result.partial);
    EXPECT_NE(result.reason.find("open"), std::string::npos);
}

}  // namespace
}  // namespace counterpart
