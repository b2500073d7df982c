// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/moves.hpp"
#include "support/spikes.hpp"

#include <memory>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

class SpectralMoves : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        shape = std::make_unique<PreparedShape>(
            prepare(test::three_spikes(3), {.n_functions = 100, .n_samples = 300}));
    }
    static void TearDownTestSuite() { shape.reset(); }

    SpectralMoves() {
        tuning.moves.most_apart = 10;
        tuning.moves.good_score = 10;
        set_rounds(3, 2);
    }

    // With as many as by default, refinement by itself mends what is to be seen here.
    void set_rounds(int n_moving, int n_afterwards) {
        tuning.moves.guided.n_rounds = tuning.moves.free.n_rounds = n_moving;
        tuning.race.second.n_rounds = n_afterwards;
    }

    Map map(const PairedMaps& maps) const {
        return scored(Level(*shape, *shape, nothing_known, tuning), maps);
    }
    Contenders moved(const PairedMaps& maps) const {
        const Level level(*shape, *shape, nothing_known, tuning);
        return move_extremities({.in_race = {scored(level, maps)}}, level, {});
    }
    // Mean distance of images from where they belong: the two surfaces are one.
    static double error(const std::vector<Index>& images) {
        return (shape->mesh.vertices(images, Eigen::all) - shape->mesh.vertices).rowwise().norm().mean();
    }
    static double error(const Contenders& contenders) {
        return error(contenders.leader().on_vertices.b_from_a);
    }

    static inline std::unique_ptr<const PreparedShape> shape;
    SpectralTuning tuning;
    const std::vector<Index> right = test::staying(shape->mesh), wrong = test::exchanged(shape->mesh);
};

// The map exchanges two spikes, its inverse does not: either matching of them is as near.
TEST_F(SpectralMoves, TheMatchingIsTakenThatFits) {
    ASSERT_GT(error(wrong), 0.1);
    const Contenders found = moved({wrong, right});
    EXPECT_LT(error(found), 0.02);
    EXPECT_GT(found.leader().rank(), map({wrong, right}).rank() + 0.1);
    EXPECT_FALSE(found.dropped.empty()) << "the map as it was";
    for (std::size_t i = 0; i + 1 < found.in_race.size(); ++i)
        EXPECT_GE(found.in_race[i].rank(), found.in_race[i + 1].rank());
}

// There and back, so that nothing tells but distances between tips.
TEST_F(SpectralMoves, LimbsThatAreExchangedAreExchangedBack) {
    set_rounds(2, 1);
    const Contenders found = moved({wrong, wrong});
    EXPECT_LT(error(found), 0.02);
    EXPECT_GT(found.leader().rank(), map({wrong, wrong}).rank() + 0.1);
    tuning.moves.n_tried = 0;
    EXPECT_GT(error(moved({wrong, wrong})), 0.05) << "or this proves nothing";
}

// Two spikes go to one, there and back: the other one has no partner on either side.
TEST_F(SpectralMoves, WhereTwoLimbsGoToOneTheyPart) {
    std::vector<Index> folded = right;
    for (const Index v : right)
        if (shape->mesh.vertices(v, 1) < 0) folded[at(v)] = wrong[at(v)];
    tuning.moves.most_apart = 0.6;
    set_rounds(1, 1);
    EXPECT_LT(error(moved({folded, folded})), 0.01);
    EXPECT_GT(error(folded), 0.03) << "or this proves nothing";
}

TEST_F(SpectralMoves, WhatFitsIsLeftAsItIs) {
    const PairedMaps start{wrong, right};
    tuning.moves.good_score = map(start).rank();
    const Contenders same = moved(start);
    ASSERT_EQ(same.in_race.size(), 1U);
    EXPECT_EQ(same.leader().on_vertices.b_from_a, wrong);
    EXPECT_EQ(same.leader().on_vertices.a_from_b, right);
    EXPECT_TRUE(same.dropped.empty());
    tuning.moves.good_score += 0.001;
    EXPECT_NE(moved(start).leader().on_vertices.b_from_a, wrong);
}

TEST_F(SpectralMoves, ARightMapStaysRight) {
    EXPECT_LT(error(moved({right, right})), 0.02);
    EXPECT_GE(moved({right, right}).leader().rank(), map({right, right}).rank());
}

TEST_F(SpectralMoves, ExchangingTheShapesExchangesTheMaps) {
    const Contenders there = moved({wrong, right}), back = moved({right, wrong});
    EXPECT_NEAR(there.leader().rank(), back.leader().rank(), 0.01);
    EXPECT_NEAR(error(there), error(back), 0.01);
}

// The tip of a limb ends halfway down a longer one, and no extremities are near enough to be matched.
TEST(SpectralMovesOfLimbs, LandmarksAndDirectionsGuideAsWell) {
    const TriangleMesh shorter = test::three_spikes(), longer = test::with_longer_spike(shorter);
    const PreparationOptions options{.n_functions = 100, .n_samples = 300};
    const PreparedShape a = prepare(shorter, options), b = prepare(longer, options);
    Eigen::Index tip = 0, bottom = 0;
    const double end = longer.vertices.col(0).maxCoeff(&tip);
    longer.vertices.col(0).minCoeff(&bottom);
    SpectralTuning tuning;
    tuning.moves.most_apart = 0;
    tuning.moves.n_tried = 0;
    tuning.moves.guided.n_rounds = tuning.moves.free.n_rounds = tuning.race.second.n_rounds = 2;
    const auto image_of_tip = [&](const Priors& priors, double good_score) {
        tuning.moves.good_score = good_score;
        const Level level(a, b, priors, tuning);
        const Map start = scored(level, {test::nearest_vertices(shorter.vertices, longer.vertices),
                                         test::nearest_vertices(longer.vertices, shorter.vertices)});
        const Contenders found = move_extremities({.in_race = {start}}, level, {});
        return longer.vertices(found.leader().on_vertices.b_from_a[at(tip)], 0);
    };
    EXPECT_LT(image_of_tip({}, 10), 0.8 * end) << "or this proves nothing";
    VertexPairs both_ends;
    for (const Eigen::Index v : {tip, bottom})
        both_ends.emplace_back(static_cast<Index>(v), static_cast<Index>(v));
    Priors along_the_limb, at_both_ends = make_priors(a, b, both_ends, {});
    along_the_limb.directions_a = along_the_limb.directions_b = Eigen::Vector3d::UnitX();
    at_both_ends.pinned = false;
    for (const Priors* priors : {&along_the_limb, &at_both_ends})  // followed by a map that fits, too
        EXPECT_GT(image_of_tip(*priors, 0), 0.95 * end);
}

}  // namespace
}  // namespace counterpart::spectral_match
