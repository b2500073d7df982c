// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "match/spectral/contenders.hpp"
#include "support/spikes.hpp"

#include <cmath>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class SpectralContenders : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        shape = std::make_unique<PreparedShape>(
            prepare(test::three_spikes(3), {.n_functions = 60, .n_samples = 300}));
    }
    static void TearDownTestSuite() { shape.reset(); }

    // One of four that differ: the `n` th spike goes elsewhere.
    Map map(int n, double rank) const {
        std::vector<Index> images = test::staying(shape->mesh);
        const Points& x = shape->mesh.vertices;
        for (const Index v : test::staying(shape->mesh))
            if ((n == 1 && x(v, 0) > 0.3) || (n == 2 && x(v, 1) > 0.2) || (n == 3 && x(v, 1) < -0.2))
                images[at(v)] = wrong[at(v)] == v ? wrong[0] : 0;
        Map result = scored(level, {images, images});
        result.score.total = rank;
        return result;
    }
    Contenders kept(std::vector<Map> maps, const Heat& heat) const {
        Contenders contenders{.in_race = std::move(maps)};
        contenders.keep(heat, MapDistance(level.pair), distinct);
        return contenders;
    }
    static std::vector<double> ranks(const std::vector<Map>& maps) {
        std::vector<double> result;
        for (const Map& map : maps) result.push_back(map.rank());
        return result;
    }

    static inline std::unique_ptr<const PreparedShape> shape;
    const SpectralTuning tuning{};
    const Level level{*shape, *shape, nothing_known, tuning};
    const Distinctness distinct{.mean = 0.01, .moved_share = 0.01};
    const std::vector<Index> wrong = test::exchanged(shape->mesh);
    const Schedule brief{
        .n_rounds = 2, .first_size = 30, .last_size = 60, .first_length = 0.3, .last_length = 0.1};
};

TEST_F(SpectralContenders, AreInTheOrderOfTheirScores) {
    const Contenders contenders = kept({map(0, 0.5), map(1, 0.9), map(2, 0.7)}, {3, infinity});
    EXPECT_EQ(ranks(contenders.in_race), (std::vector{0.9, 0.7, 0.5}));
    EXPECT_EQ(contenders.leader().rank(), 0.9);
    EXPECT_NEAR(contenders.lead(), 0.2, 1e-12);
    EXPECT_TRUE(contenders.dropped.empty());
}

TEST_F(SpectralContenders, TheOnlyOneLeadsByAnyMargin) {
    EXPECT_EQ(kept({map(0, 0.5)}, {3, infinity}).lead(), infinity);
}

TEST_F(SpectralContenders, TheSameMapCountsOnce) {
    const Contenders contenders = kept({map(0, 0.5), map(1, 0.6), map(0, 0.7), map(1, 0.8)}, {4, infinity});
    EXPECT_EQ(ranks(contenders.in_race), (std::vector{0.8, 0.7}));
    EXPECT_EQ(contenders.dropped.size(), 2U);
}

TEST_F(SpectralContenders, WhatIsTooFarBehindOrOneTooManyDropsOut) {
    const std::vector<Map> all{map(0, 1), map(1, 0.9), map(2, 0.75), map(3, 0.5)};
    EXPECT_EQ(ranks(kept(all, {4, 0.3}).in_race), (std::vector{1.0, 0.9, 0.75}));
    EXPECT_EQ(ranks(kept(all, {2, 0.3}).in_race), (std::vector{1.0, 0.9}));
    EXPECT_EQ(ranks(kept(all, {4, 0}).in_race), (std::vector{1.0})) << "the leader stays";
}

TEST_F(SpectralContenders, WhatDropsOutKnowsHowFarBehindItWas) {
    const Contenders contenders =
        kept({map(0, 1), map(1, 0.9), map(2, 0.75), map(0, 0.6), map(3, 0.5)}, {3, 0.2});
    ASSERT_EQ(contenders.dropped.size(), 3U);
    for (const Dropped& out : contenders.dropped) EXPECT_EQ(out.behind, 1 - out.map.rank());
}

TEST_F(SpectralContenders, OneWithoutAScoreIsLast) {
    const Contenders contenders = kept({map(1, -infinity), map(0, 0.1)}, {2, infinity});
    EXPECT_EQ(contenders.leader().rank(), 0.1);
    const Contenders limited = kept({map(1, -infinity), map(0, 0.1), map(2, 0)}, {3, 10});
    EXPECT_EQ(limited.in_race.size(), 2U);
    EXPECT_EQ(limited.dropped.at(0).behind, infinity);
    for (const Dropped& out : kept({map(1, -infinity), map(0, -infinity)}, {1, 0}).dropped)
        EXPECT_FALSE(std::isnan(out.behind));
}

TEST_F(SpectralContenders, AreRefinedEachForItself) {
    const std::vector<Start> starts{{map(0, 0), brief}, {map(1, 0), brief}, {map(2, 0), {.n_rounds = 0}}};
    const auto all = [&] { return refine_all(level, starts, {}); };
    const std::vector<Map> together = with_threads(2, all), on_one = with_threads(1, all);
    ASSERT_EQ(together.size(), starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Map alone = Refiner(level)(starts[i].map, starts[i].schedule);
        for (const std::vector<Map>* maps : {&together, &on_one}) {
            EXPECT_EQ((*maps)[i].on_vertices.b_from_a, alone.on_vertices.b_from_a);
            EXPECT_EQ((*maps)[i].on_vertices.a_from_b, alone.on_vertices.a_from_b);
            EXPECT_EQ((*maps)[i].rank(), alone.rank());
        }
    }
    EXPECT_TRUE(refine_all(level, {}, {}).empty());
}

TEST_F(SpectralContenders, OnceMoreNeverCosts) {
    const std::vector<Index> right = test::staying(shape->mesh);
    std::vector<Index> torn = right;
    for (std::size_t v = 0; v < torn.size(); v += 10) torn[v] = 0;
    const Map gaining = scored(level, {torn, right}), losing = scored(level, {right, wrong});
    ASSERT_GT(Refiner(level)(gaining, brief).rank(), gaining.rank() + 0.05);
    ASSERT_LT(Refiner(level)(losing, brief).rank(), losing.rank());
    std::vector<Map> maps{gaining, losing};
    refine_again(maps, level, brief, {});
    EXPECT_EQ(maps[0].rank(), Refiner(level)(gaining, brief).rank());
    EXPECT_EQ(maps[1].rank(), losing.rank());
    EXPECT_EQ(maps[1].on_vertices.a_from_b, wrong);
}

}  // namespace
}  // namespace counterpart::spectral_match
