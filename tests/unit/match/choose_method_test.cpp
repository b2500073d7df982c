// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/cuts.hpp"
#include "support/disguise.hpp"
#include "support/edits.hpp"
#include "support/expect_error.hpp"
#include "support/messages.hpp"
#include "support/quick_match.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/choose_method.hpp>
#include <counterpart/match/verdict.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

using test::expect_error;
using test::lines_of;
using test::quick;

const TriangleMesh chosen_for = make_body({.subdivisions = 1});

struct PairOfWay {
    const char* name;
    TriangleMesh source, target;
    MatchMethod method;
};
std::vector<PairOfWay> pair_of_each_way() {
    return {{"same", chosen_for, test::shuffled(chosen_for, 1).mesh, MatchMethod::exact},
            {"nearly the same", chosen_for, test::shuffled(test::without_vertex(chosen_for, 3).mesh, 1).mesh,
             MatchMethod::exact},
            {"unrelated", make_torus(24, 12), chosen_for, MatchMethod::spectral},
            {"a part", test::cut_by_plane(chosen_for, {0, 1, 0}, chosen_for.vertices.col(1).mean()).mesh,
             make_torus(24, 12), MatchMethod::partial},
            {"tiny", make_icosphere(0), make_icosphere(1), MatchMethod::nearest}};
}

TEST(ChooseMethod, TellsWhatMatchThenTakesAndWhy) {
    for (const PairOfWay& pair : pair_of_each_way()) {
        SCOPED_TRACE(pair.name);
        const MethodChoice choice = choose_method(pair.source, pair.target, quick());
        EXPECT_EQ(choice.method, pair.method);
        const MatchResult result = match(pair.source, pair.target, quick());
        EXPECT_EQ(choice.method, result.method);
        EXPECT_EQ(choice.reason, result.reason);
    }
    EXPECT_EQ(choose_method(chosen_for, chosen_for, quick(MatchMethod::nearest)).method,
              MatchMethod::nearest);
    EXPECT_EQ(choose_method(chosen_for, chosen_for, quick(MatchMethod::nearest)).reason, "");
}

// A pattern piece: z is 0 everywhere, which contradicts nothing that is said of directions.
TEST(ChooseMethod, AFlatMeshHasNoOrderAlongItsNormal) {
    TriangleMesh sheet = make_grid(9, 5);
    for (Index v = 0; v < sheet.n_vertices(); ++v) sheet.vertices(v, 0) += 0.02 * std::sin(3.0 * v);
    MatchOptions options = quick();
    options.spectral.aligned = true;
    const MatchResult result = match(sheet, test::shuffled(sheet, 1).mesh, options);
    EXPECT_NE(result.method, MatchMethod::spectral) << result.reason;
    EXPECT_FALSE(contains(result.messages, MessageCode::against_request)) << lines_of(result.messages);
}

// Partial matching keeps distances from all samples: of too many it is not chosen, and the reason says so.
TEST(ChooseMethod, AnOpenMeshOfTooManyVerticesForItsSamplesIsNotForPartial) {
    const TriangleMesh large = make_grid(400, 250);
    TriangleMesh small = make_icosphere(3);
    small.triangles.conservativeResize(small.n_triangles() / 2, 3);
    MatchOptions options = quick();
    EXPECT_EQ(choose_method(large, small, options).method, MatchMethod::partial);
    options.partial.n_samples = 5000;
    const MethodChoice choice = choose_method(large, small, options);
    EXPECT_EQ(choice.method, MatchMethod::spectral);
    test::expect_part(choice.reason, "simplify it to at most 90000");
}

TEST(ChooseMethod, RefusesWhatMatchRefuses) {
    EXPECT_THROW(choose_method({}, chosen_for), InvalidInput);
    MatchOptions options;
    options.min_shared = 0;
    EXPECT_THROW(choose_method(chosen_for, chosen_for, options), InvalidInput);
    options = {};
    options.spectral.excluded = {{0, 999999}};
    expect_error<InvalidInput>([&] { choose_method(chosen_for, chosen_for, options); }, "out of range");
}

// The recipe for folders on its easiest pair: the map is found, and that the cache was not needed is said.
TEST(ChooseMethod, AnOptionThatTheChosenMethodDoesNotUseIsANotice) {
    const TriangleMesh target = test::shuffled(chosen_for, 1).mesh;
    MatchOptions options;
    options.prepared_shape = [](MeshView, const SpectralShapeOptions&) -> SpectralShape {
        throw InvalidInput("not to be called");
    };
    options.spectral_shape.seed = 7;
    const MethodChoice choice = choose_method(chosen_for, target, options);
    EXPECT_EQ(choice.method, MatchMethod::exact);
    EXPECT_EQ(lines_of(choice.messages),
              "option_not_used, notice: cache is not used by 'exact'\n"
              "option_not_used, notice: seed is not used by 'exact'\n");
    const MatchResult result = match(chosen_for, target, options);
    EXPECT_EQ(verdict(result).advice, Advice::use);
    EXPECT_NE(lines_of(result.messages).find(lines_of(choice.messages)), std::string::npos);
    EXPECT_TRUE(choose_method(chosen_for, target).messages.empty());
}

TEST(ChooseMethod, WhatIsKnownOfTheMapIsRefusedByMethodsThatDoNotFollowIt) {
    std::vector<MatchOptions> known(5);
    known[0].spectral.landmarks = {{0, 0}};
    known[1].spectral.excluded = {{0, 1}};
    known[2].spectral.aligned = true;
    known[3].spectral.up = Eigen::Vector3d::UnitY();
    known[4].partial.excluded = {{0, 1}};
    const TriangleMesh tiny = make_icosphere(0), other = make_icosphere(1);
    for (std::size_t i = 0; i < known.size(); ++i) {
        SCOPED_TRACE(i);
        for (const MatchMethod method :
             {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::nearest, MatchMethod::assignment}) {
            known[i].method = method;
            expect_error<InvalidInput>([&] { match(chosen_for, chosen_for, known[i]); },
                                       "does not follow it");
            EXPECT_THROW(choose_method(chosen_for, chosen_for, known[i]), InvalidInput);
        }
        known[i].method = MatchMethod::automatic;
        expect_error<InvalidInput>([&] { match(tiny, other, known[i]); }, "does not follow it");
    }
}

// The isomorphism takes each vertex to itself; whoever says that this is wrong is heard.
TEST(ChooseMethod, ConnectivityIsNotBelievedAgainstWhatIsKnownOfTheMap) {
    MatchOptions options = quick();
    options.spectral.excluded = {{5, 600}};
    EXPECT_EQ(choose_method(chosen_for, chosen_for, options).method, MatchMethod::exact);
    options.spectral.excluded = {{5, 5}};
    EXPECT_EQ(choose_method(chosen_for, chosen_for, options).method, MatchMethod::spectral);
    options.spectral.excluded.clear();
    options.spectral.up = Eigen::Vector3d::UnitY();
    EXPECT_EQ(choose_method(chosen_for, chosen_for, options).method, MatchMethod::exact);
    TriangleMesh upside_down = chosen_for;
    upside_down.vertices.rightCols(2) *= -1;
    EXPECT_EQ(choose_method(chosen_for, upside_down, options).method, MatchMethod::spectral);
}

// Under automatic, an open mesh takes partial, which must follow what is known.
TEST(ChooseMethod, PartialFollowsWhatIsKnownOfTheMap) {
    const TriangleMesh part =
        test::cut_by_plane(chosen_for, {0, 1, 0}, chosen_for.vertices.col(1).mean()).mesh;
    TriangleMesh other = retriangulate(chosen_for, {.seed = 4}).mesh;
    other.vertices.col(0).array() += 5;  // not in the same place
    MatchOptions options;
    options.partial.same_scale = true;
    options.partial.n_samples = 300;
    const MatchResult free = match(part, other, options);
    ASSERT_EQ(free.method, MatchMethod::partial);
    const Index image = free.target_from_source[40];
    ASSERT_NE(image, VertexMap::unmatched);
    options.spectral.excluded = {{40, image}};
    const MatchResult kept = match(part, other, options);
    EXPECT_EQ(kept.method, MatchMethod::partial);
    const bool moved =
        (other.vertices.row(kept.target_from_source[40]) - other.vertices.row(image)).norm() > 0.01;
    EXPECT_NE(moved, contains(kept.messages, MessageCode::against_request)) << lines_of(kept.messages);
}

}  // namespace
}  // namespace counterpart
