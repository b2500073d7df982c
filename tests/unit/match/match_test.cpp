// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/cuts.hpp"
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/expect_error.hpp"
#include "support/messages.hpp"
#include "support/quick_match.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/assignment.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/nearest.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::count_unmatched;
using test::expect_part;
using test::lines_of;
using test::quick;

TEST(Match, MeshesOfVeryDifferentSizeAreNotComparedInDetail) {
    const TriangleMesh source = make_torus(20, 15);
    TriangleMesh target = make_torus(40, 30);
    target.vertices.rowwise() += Eigen::RowVector3d(5, 0, 0);
    for (const auto& [from, to] : {std::pair(source, target), std::pair(target, source)}) {
        const MatchResult result = match(from, to, quick());
        EXPECT_EQ(result.method, MatchMethod::spectral);
        EXPECT_FALSE(result.differences.has_value());
        expect_part(result.reason, "the connectivity differs: ");
    }
}

TEST(Match, UnrelatedMeshesAreSpectral) {
    const TriangleMesh source = make_torus(24, 12), target = make_body({.subdivisions = 0});
    const MatchResult result = match(source, target, quick());
    EXPECT_EQ(result.method, MatchMethod::spectral);
    ASSERT_TRUE(result.exact.has_value());
    EXPECT_FALSE(result.exact->identical);
    EXPECT_EQ(result.reason, "the connectivity differs: " + result.exact->difference);
    EXPECT_EQ(count_unmatched(result.target_from_source), 0);
    ASSERT_TRUE(result.spectral.has_value());
    EXPECT_EQ(result.target_from_source, result.spectral->target_from_source);
    EXPECT_EQ(result.confidence, result.spectral->confidence);
    EXPECT_NE(lines_of(result.messages).find(lines_of(result.spectral->messages)), std::string::npos);
    EXPECT_EQ(verdict(result).advice, Advice::do_not_use) << lines_of(result.messages);
}

// Too few vertices for spectral.
TEST(Match, TinyMeshesAreMatchedByPlace) {
    TriangleMesh source = make_icosphere(0);  // 12 vertices
    source.vertices *= Eigen::Vector3d(3, 2, 1).asDiagonal();
    const TriangleMesh target = test::moved(subdivide(source), 6);
    const MatchResult result = match(source, target);
    EXPECT_EQ(result.method, MatchMethod::nearest);
    expect_part(result.reason, "the connectivity differs: ");
    expect_part(result.reason, "at least 20 vertices");
    EXPECT_TRUE(contains(result.messages, MessageCode::by_position));
    EXPECT_EQ(verdict(result).advice, Advice::check);
    EXPECT_EQ(result.confidence, Vector::Zero(12));
    EXPECT_FALSE(result.spectral.has_value());
    // The ellipsoid fits in four ways; each takes vertices to vertices and keeps their distances.
    ASSERT_EQ(count_unmatched(result.target_from_source), 0);
    const double scale = std::sqrt(surface_area(target) / surface_area(source));
    for (Index v = 0; v < 12; ++v) {
        EXPECT_LT(result.target_from_source[v], 12);
        for (Index w = 0; w < v; ++w) {
            const double length = (source.vertices.row(v) - source.vertices.row(w)).norm();
            const double found = (target.vertices.row(result.target_from_source[v]) -
                                  target.vertices.row(result.target_from_source[w]))
                                     .norm();
            EXPECT_NEAR(found, scale * length, 1e-9);
        }
    }
}

TEST(Match, MeshesWithoutAreaAreMatchedByPlace) {
    TriangleMesh line = make_grid(5, 5);
    line.vertices.rightCols(2).setZero();
    const TriangleMesh target = make_icosphere(1);
    const MatchResult result = match(line, target);
    EXPECT_EQ(result.method, MatchMethod::nearest);
    expect_part(result.reason, "no area");
    EXPECT_EQ(verdict(result).advice, Advice::check);
    EXPECT_EQ(count_unmatched(result.target_from_source), 0);
}

// Wound as they should be, with the same connectivity.
TEST(Match, AMirrorImageIsNotTakenWhereItIsExcluded) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const TriangleMesh target = test::mirrored(deform(source, {.bend = 0.4}));
    EXPECT_TRUE(match(source, target, quick()).exact->mirrored);
    MatchOptions options = quick();
    options.spectral.mirror = Mirror::never;
    const MatchResult result = match(source, target, options);
    EXPECT_EQ(result.method, MatchMethod::spectral) << result.reason;
    EXPECT_FALSE(result.spectral->mirrored);
    options.method = MatchMethod::exact;
    EXPECT_THROW(match(source, target, options), InvalidInput);
    for (const MatchMethod method : {MatchMethod::frontiers, MatchMethod::nearest, MatchMethod::assignment}) {
        options.method = method;
        EXPECT_THROW(match(source, target, options), InvalidInput);
    }
}

// The left half of a bone against the right bone.
TEST(Match, TheMirroredMapOfAPart) {
    TriangleMesh whole = make_body({.subdivisions = 1});
    for (double& x : whole.vertices.col(0)) x *= x > 0 ? 1.7 : 1;  // one side unlike the other
    const test::PartOfMesh part = test::cut_by_plane(whole, {0, 1, 0}, whole.vertices.col(1).mean());
    const TriangleMesh target = test::mirrored(deform(whole, {.bend = 0.3}));
    MatchOptions options = quick();
    options.partial.same_scale = true;
    options.spectral.mirror = Mirror::always;
    const auto error = [&](const MatchResult& result) {
        double sum = 0;
        for (Index v = 0; v < part.mesh.n_vertices(); ++v)
            sum += (target.vertices.row(part.whole_from_part[v]) -
                    target.vertices.row(std::max<Index>(result.target_from_source[v], 0)))
                       .norm();
        return sum / part.mesh.n_vertices() / std::sqrt(surface_area(target));
    };
    const MatchResult result = match(part.mesh, target, options);
    EXPECT_EQ(result.method, MatchMethod::partial) << result.reason;
    EXPECT_TRUE(result.partial->mirrored);
    EXPECT_LT(error(result), 0.05);
    EXPECT_FALSE(contains(result.messages, MessageCode::handedness_unknown));
    options.spectral.mirror = Mirror::automatic;
    options.method = MatchMethod::partial;
    const MatchResult tried = match(part.mesh, target, options);
    EXPECT_TRUE(tried.partial->mirrored);
    EXPECT_TRUE(contains(tried.messages, MessageCode::mirror_image));
    EXPECT_LT(error(tried), 0.05);
    options.spectral.mirror = Mirror::never;
    EXPECT_FALSE(match(part.mesh, target, options).partial->mirrored);
}

TEST(Match, TheMirroredMapSkipsExact) {
    const TriangleMesh source = make_body({.subdivisions = 1, .symmetric = true});
    const test::DisguisedMesh target = test::shuffled(source, 9);
    EXPECT_EQ(match(source, target.mesh).method, MatchMethod::exact);
    MatchOptions options = quick();
    options.spectral.symmetric = true;
    const MatchResult result = match(source, target.mesh, options);
    EXPECT_EQ(result.method, MatchMethod::spectral);
    EXPECT_EQ(result.reason, "the mirrored map was asked for");
    EXPECT_FALSE(result.exact.has_value());
    EXPECT_FALSE(result.differences.has_value());
    Index off_middle = 0, on_other_side = 0;
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const double x = source.vertices(v, 0);
        if (std::abs(x) < 0.1) continue;
        ++off_middle;
        on_other_side += x * target.mesh.vertices(result.target_from_source[v], 0) < 0 ? 1 : 0;
    }
    ASSERT_GT(off_middle, 100);
    EXPECT_GT(on_other_side, 0.95 * off_middle);
}

TEST(Match, LandmarksSkipExact) {
    const TriangleMesh source = make_body({.subdivisions = 1});
    const test::DisguisedMesh target = test::posed(source);
    MatchOptions options = quick();
    for (const Index v : {0, 100, 300, 600, 900})
        options.spectral.landmarks.emplace_back(v, target.mesh_from_original[v]);
    const MatchResult result = match(source, target.mesh, options);
    EXPECT_EQ(result.method, MatchMethod::spectral);
    EXPECT_EQ(result.reason, "landmarks are given");
    EXPECT_FALSE(result.exact.has_value());
}

TEST(Match, EachMethodByName) {
    const TriangleMesh source = make_body({.subdivisions = 0});
    const test::DisguisedMesh target = test::shuffled(source, 9);  // in place: all find the truth
    for (const MatchMethod method : {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::spectral,
                                     MatchMethod::nearest, MatchMethod::assignment}) {
        SCOPED_TRACE(to_string(method));
        const MatchOptions options = quick(method);
        const MatchResult result = match(source, target.mesh, options);
        EXPECT_EQ(result.method, method);
        EXPECT_EQ(result.reason, "");
        EXPECT_EQ(result.n_filled, 0);
        EXPECT_FALSE(result.differences.has_value());
        EXPECT_EQ(result.exact.has_value(), method == MatchMethod::exact);
        EXPECT_EQ(result.frontiers.has_value(), method == MatchMethod::frontiers);
        EXPECT_EQ(result.spectral.has_value(), method == MatchMethod::spectral);
        ASSERT_EQ(result.stages.size(), 2U);
        EXPECT_EQ(result.stages[0].stage, to_string(method));
        EXPECT_EQ(result.stages[1].stage, "verdict");
        ASSERT_EQ(result.confidence.size(), source.n_vertices());
        if (method == MatchMethod::spectral) {
            EXPECT_EQ(result.target_from_source,
                      match_spectral(source, target.mesh, {}, options.spectral_shape).target_from_source);
            EXPECT_EQ(result.confidence, result.spectral->confidence);
        } else {
            EXPECT_EQ(result.target_from_source, target.mesh_from_original);
        }
        if (method == MatchMethod::exact || method == MatchMethod::frontiers) {
            EXPECT_EQ(result.confidence, Vector::Ones(source.n_vertices()));
        }
        if (method == MatchMethod::nearest || method == MatchMethod::assignment) {
            EXPECT_EQ(result.confidence, Vector::Zero(source.n_vertices()));
        }
    }
}

TEST(Match, NamesAreThoseOfTheMethods) {
    EXPECT_EQ(to_string(MatchMethod::automatic), "automatic");
    EXPECT_EQ(to_string(MatchMethod::exact), "exact");
    EXPECT_EQ(to_string(MatchMethod::frontiers), "frontiers");
    EXPECT_EQ(to_string(MatchMethod::spectral), "spectral");
    EXPECT_EQ(to_string(MatchMethod::nearest), "nearest");
    EXPECT_EQ(to_string(MatchMethod::assignment), "assignment");
}

TEST(Match, ExactByNameLeavesWhatDiffersUnmatched) {
    const TriangleMesh source = make_body({.subdivisions = 2});
    const test::DisguisedMesh target = test::posed(test::without_vertex(source, 3).mesh);
    const MatchResult result = match(source, target.mesh, quick(MatchMethod::exact));
    EXPECT_EQ(result.method, MatchMethod::exact);
    ASSERT_TRUE(result.differences.has_value());
    EXPECT_EQ(result.target_from_source, result.differences->target_from_source);
    EXPECT_GE(count_unmatched(result.target_from_source), 1);
    EXPECT_EQ(result.n_filled, 0);
    for (Index v = 0; v < source.n_vertices(); ++v)
        EXPECT_EQ(result.confidence[v] == 0, result.target_from_source[v] == VertexMap::unmatched) << v;
}

TEST(Match, AMethodByNameThrowsWhatItThrowsItself) {
    const TriangleMesh small = make_icosphere(0), other = make_icosphere(1);
    test::expect_error<InvalidInput>([&] { match(small, other, quick(MatchMethod::spectral)); },
                                     "at least 20 vertices");
    EXPECT_THROW(match(small, other, quick(MatchMethod::frontiers)), InvalidInput);
}

TEST(Match, RefusesInvalidMeshesAndOptionsOutOfRange) {
    const TriangleMesh mesh = make_icosphere(2);
    EXPECT_THROW(match({}, mesh), InvalidInput);
    EXPECT_THROW(match(mesh, {}), InvalidInput);
    for (const double min_shared : {0.49, 1.01, std::numeric_limits<double>::quiet_NaN()}) {
        MatchOptions options;
        options.min_shared = min_shared;
        test::expect_error<InvalidInput>([&] { match(mesh, mesh, options); }, "min_shared");
    }
    for (const double min_shared : {0.5, 1.0}) {
        MatchOptions options;
        options.min_shared = min_shared;
        EXPECT_NO_THROW(match(mesh, mesh, options));
    }
    MatchOptions options;
    options.n_threads = -1;
    test::expect_error<InvalidInput>([&] { match(mesh, mesh, options); }, "n_threads");
    options = quick(MatchMethod::spectral);
    options.spectral.n_alternatives = -1;
    EXPECT_THROW(match(mesh, mesh, options), InvalidInput);
    options = quick(MatchMethod::spectral);
    options.spectral_shape.basis_size = 10;
    EXPECT_THROW(match(mesh, mesh, options), InvalidInput);
    options = quick();
    options.spectral.landmarks = {{0, 0}, {1, 1}, {2, 9999}};  // not UnsuitableMesh: no other method is tried
    EXPECT_THROW(match(mesh, mesh, options), InvalidInput);
}

struct Pair {
    const char* name;
    TriangleMesh source, target;
};
// One that ends at each of the ways of automatic.
std::vector<Pair> pairs_for_each_way() {
    const TriangleMesh body = make_body({.subdivisions = 0});
    return {{"same", body, test::shuffled(body, 1).mesh},
            {"nearly the same", body, test::shuffled(test::without_vertex(body, 3).mesh, 1).mesh},
            {"unrelated", make_torus(24, 12), body},
            {"tiny", make_icosphere(0), make_icosphere(1)}};
}

TEST(Match, CanBeStopped) {
    for (const Pair& pair : pairs_for_each_way()) {
        for (const double limit : {0.0, 0.03, 0.5, 1.0}) {
            MatchOptions options = quick();
            options.progress = [&](double fraction) { return fraction < limit; };
            EXPECT_THROW(match(pair.source, pair.target, options), Canceled) << pair.name << " " << limit;
        }
    }
    const TriangleMesh body = make_body({.subdivisions = 0});
    for (const MatchMethod method : {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::spectral,
                                     MatchMethod::nearest, MatchMethod::assignment}) {
        MatchOptions options = quick(method);
        options.progress = [](double) { return false; };
        EXPECT_THROW(match(body, body, options), Canceled) << to_string(method);
    }
}

TEST(Match, SameForAnyNumberOfThreadsAndProgressNeverDecreases) {
    for (const Pair& pair : pairs_for_each_way()) {
        SCOPED_TRACE(pair.name);
        std::vector<double> fractions;
        MatchOptions options = quick();
        options.n_threads = 1;
        const MatchResult one = match(pair.source, pair.target, options);
        options.n_threads = 2;
        options.progress = [&](double fraction) {
            fractions.push_back(fraction);
            return true;
        };
        const MatchResult two = match(pair.source, pair.target, options);
        EXPECT_EQ(one.method, two.method);
        EXPECT_EQ(one.reason, two.reason);
        EXPECT_EQ(one.target_from_source, two.target_from_source);
        EXPECT_EQ(one.confidence, two.confidence);
        ASSERT_FALSE(fractions.empty());
        EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
        EXPECT_GE(fractions.front(), 0);
        EXPECT_EQ(fractions.back(), 1);
    }
}

}  // namespace
}  // namespace counterpart
