// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/race.hpp"
#include "support/spiked_pair.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

class SpectralRace : public test::SpikedPair {
  protected:
    static Contenders raced(const PreparedShape& from, const PreparedShape& to, const SpectralTuning& with,
                            const Priors& priors = nothing_known) {
        Stopwatch watch;
        return race(Level(from, to, priors, with), {}, watch);
    }
    // Mean distance of the images of vertices from where they belong.
    static double error(const std::vector<Index>& images, const PreparedShape& to) {
        return (to.mesh.vertices(images, Eigen::all) - to.mesh.vertices).rowwise().norm().mean();
    }

    SpectralTuning tuning;
};

TEST_F(SpectralRace, TheRightMapLeads) {
    ASSERT_GT(error(test::exchanged(a->mesh), *a), 0.1) << "what a wrong one does";
    const Map leader = raced(*a, *b, tuning).leader();
    EXPECT_LT(error(leader.on_vertices.b_from_a, *b), 0.03);
    EXPECT_LT(error(leader.on_vertices.a_from_b, *a), 0.03);
    EXPECT_EQ(leader.rank(), score(Level(*a, *b, nothing_known, tuning), leader.on_vertices).total);
}

TEST_F(SpectralRace, ADecidedOneEndsEarlyWithTheSameLeader) {
    const Contenders early = raced(*a, *a, tuning);
    tuning.race.sure_lead = never;
    const Contenders late = raced(*a, *a, tuning);
    EXPECT_EQ(early.in_race.size(), 1U);
    EXPECT_LT(early.in_race.size() + early.dropped.size(), late.in_race.size() + late.dropped.size());
    EXPECT_LT(error(early.leader().on_vertices.b_from_a, *a), 0.02);
    EXPECT_LT(error(late.leader().on_vertices.b_from_a, *a), 0.02);
    EXPECT_NEAR(early.leader().rank(), late.leader().rank(), 0.05);
}

TEST_F(SpectralRace, WhatDropsOutKnowsHowFarBehindItWas) {
    const Contenders found = raced(*a, *b, tuning);
    const MapDistance distance(SampledPair(*a, *b, all_samples));
    bool has_another = false;
    ASSERT_FALSE(found.dropped.empty());
    for (const Dropped& out : found.dropped) {
        EXPECT_TRUE(std::isfinite(out.behind));
        EXPECT_GE(out.behind, 0);
        EXPECT_EQ(out.map.on_vertices.b_from_a.size(), at(a->mesh.n_vertices()));
        const bool is_another = distance(found.leader().maps, out.map.maps) > 0.1;
        has_another = has_another || is_another;
        if (is_another) {
            EXPECT_GT(out.behind, 0.05);
        }
    }
    EXPECT_TRUE(has_another);
}

TEST_F(SpectralRace, ExchangingTheShapesExchangesTheMaps) {
    const Map there = raced(*a, *b, tuning).leader(), back = reversed(raced(*b, *a, tuning).leader());
    EXPECT_NEAR(there.rank(), back.rank(), 0.02);
    const MapDistance distance(SampledPair(*a, *b, all_samples));
    EXPECT_LT(distance(there.maps, back.maps), 0.02);
}

TEST_F(SpectralRace, ThreadsDoNotChangeTheBytes) {
    tuning.race.sure_lead = never;
    const auto found = [&] { return raced(*a, *b, tuning); };
    const Contenders one = with_threads(1, found), two = with_threads(2, found);
    ASSERT_EQ(one.in_race.size(), two.in_race.size());
    for (std::size_t i = 0; i < one.in_race.size(); ++i) {
        EXPECT_EQ(one.in_race[i].on_vertices.b_from_a, two.in_race[i].on_vertices.b_from_a);
        EXPECT_EQ(one.in_race[i].on_vertices.a_from_b, two.in_race[i].on_vertices.a_from_b);
        EXPECT_EQ(one.in_race[i].rank(), two.in_race[i].rank());
    }
    ASSERT_EQ(one.dropped.size(), two.dropped.size());
    for (std::size_t i = 0; i < one.dropped.size(); ++i) {
        EXPECT_EQ(one.dropped[i].map.on_vertices.b_from_a, two.dropped[i].map.on_vertices.b_from_a);
        EXPECT_EQ(one.dropped[i].behind, two.dropped[i].behind);
    }
}

TEST_F(SpectralRace, ItsStagesAreTimedAndCanBeCanceled) {
    Stopwatch watch;
    WorkState state;
    const Level level(*a, *a, nothing_known, tuning);
    race(level, ProgressRange(state, 0, 0.5), watch);
    EXPECT_EQ(state.fraction, 0.5);
    ASSERT_EQ(watch.stages().size(), 2U);
    EXPECT_EQ(watch.stages()[0].stage, "proposals");
    EXPECT_EQ(watch.stages()[1].stage, "race");
    state.canceled = true;
    EXPECT_THROW(race(level, ProgressRange(state), watch), Canceled);
}

// A half turn about x takes the body to itself: spikes of one length along +y and -y.
TEST_F(SpectralRace, ALandmarkDecidesBetweenSymmetricMaps) {
    TriangleMesh mesh = test::three_spikes(3);
    for (Index v = 0; v < mesh.n_vertices(); ++v) mesh.vertices(v, 1) *= mesh.vertices(v, 1) > 0 ? 1.3 : 1.0;
    const PreparedShape body = prepare(mesh, {.n_functions = 100, .n_samples = 300});
    Eigen::Index top = 0, bottom = 0;
    body.mesh.vertices.col(1).maxCoeff(&top);
    body.mesh.vertices.col(1).minCoeff(&bottom);
    for (const auto& [from, to] : {std::pair(top, top), std::pair(top, bottom), std::pair(bottom, top)}) {
        const Priors priors =
            make_priors(body, body, VertexPairs{{static_cast<Index>(from), static_cast<Index>(to)}}, {});
        const PairedMaps found = raced(body, body, tuning, priors).leader().on_vertices;
        EXPECT_EQ(found.b_from_a[at(from)], static_cast<Index>(to));
        const auto other = from == top ? bottom : top, image = to == top ? bottom : top;
        EXPECT_LT((body.mesh.vertices.row(found.b_from_a[at(other)]) - body.mesh.vertices.row(image)).norm(),
                  0.1)
            << "and so the other one goes, too";
    }
}

}  // namespace
}  // namespace counterpart::spectral_match
