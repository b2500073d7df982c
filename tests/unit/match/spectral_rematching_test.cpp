// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/refined_score.hpp"
#include "match/spectral/rematching.hpp"
#include "numerics/nearest_neighbors.hpp"
#include "support/spikes.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

struct SpectralRematching : testing::Test {
    const PreparedShape shape = prepare(test::three_spikes(), {.n_functions = 100, .n_samples = 300});
    const SampledPair pair{shape, shape, all_samples, CueTuning{}.radius};
    RematchingTuning tuning{.most_apart = 10, .good_score = 10};
    std::vector<Index> identity, exchanged;  // what exchanges +y and -y

    SpectralRematching() : identity(at(shape.mesh.n_vertices())) {
        std::iota(identity.begin(), identity.end(), 0);
        const numerics::NearestNeighbors nearest(shape.mesh.vertices);
        for (const Index v : identity) {
            Eigen::RowVector3d mirrored = shape.mesh.vertices.row(v);
            mirrored[1] *= -1;
            exchanged.push_back(nearest.closest(mirrored).index);
        }
    }

    Candidate candidate(PairedMaps maps) const {
        Candidate result;
        result.maps = between_samples(pair, maps);
        result.refined_score = refined_score(pair, maps, {});
        result.on_vertices = std::move(maps);
        return result;
    }

    std::vector<Candidate> rematched(const Candidate& map, int n_rounds = 8) const {
        return rematch_extremities(map, pair, tuning, {},
                                   {.last_size = 100, .n_rounds = n_rounds, .goes_on = false});
    }

    // Mean distance of images from where they belong: the two surfaces are one.
    double error(const Candidate& map) const {
        return (shape.mesh.vertices(map.on_vertices.b_from_a, Eigen::all) - shape.mesh.vertices)
            .rowwise()
            .norm()
            .mean();
    }
};

// The map exchanges two spikes, its inverse does not: either matching of them is as near.
TEST_F(SpectralRematching, TheMatchingIsTakenThatFits) {
    const Candidate start = candidate({exchanged, identity});
    ASSERT_GT(error(start), 0.1);
    const std::vector<Candidate> found = rematched(start);
    ASSERT_GE(found.size(), 2U);
    EXPECT_LT(error(found.front()), 0.02);
    EXPECT_TRUE(found.front().guides.empty());
    EXPECT_EQ(found.back().on_vertices.b_from_a, start.on_vertices.b_from_a);
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        EXPECT_GT(found[i].refined_score, found[i + 1].refined_score);
}

TEST_F(SpectralRematching, TipsThatGoToTipsKeepThem) {
    const std::vector<Candidate> found = rematched(candidate({exchanged, exchanged}));
    EXPECT_GT(error(found.front()), 0.1);
}

TEST_F(SpectralRematching, WhatIsTooFarApartIsNotMatched) {
    tuning.most_apart = 0.1;
    EXPECT_GT(error(rematched(candidate({exchanged, identity})).front()), 0.05);
}

// Two spikes go to one, there and back: the other one is bare on both sides. So few rounds do not reach it
// but from where the guides lead.
TEST_F(SpectralRematching, BareExtremitiesAreMatchedHoweverFarApart) {
    std::vector<Index> folded = identity;
    for (const Index v : identity)
        if (shape.mesh.vertices(v, 1) < 0) folded[at(v)] = exchanged[at(v)];
    const Candidate start = candidate({folded, folded});
    tuning.most_apart = 0.6;
    EXPECT_LT(error(rematched(start, 2).front()), 0.02);
    const Candidate on_one_side = candidate({folded, identity}), found = rematched(on_one_side, 2).front();
    tuning.bare = 10;  // nothing is
    EXPECT_GT(error(rematched(start, 2).front()), 0.05) << "or this proves nothing";
    EXPECT_EQ(rematched(on_one_side, 2).front().on_vertices.b_from_a, found.on_vertices.b_from_a);
    tuning.bare = RematchingTuning{}.bare;
    tuning.far_rings = 1;
    EXPECT_GT(error(rematched(start, 2).front()), 0.05);
}

TEST_F(SpectralRematching, WhatFitsIsLeftAsItIs) {
    const Candidate start = candidate({exchanged, identity});
    tuning.good_score = start.refined_score;
    EXPECT_EQ(rematched(start).size(), 1U);
    tuning.good_score += 0.001;
    EXPECT_GT(rematched(start).size(), 1U);
}

TEST_F(SpectralRematching, ARightMapStaysRight) {
    const std::vector<Candidate> found = rematched(candidate({identity, identity}));
    EXPECT_LT(error(found.front()), 0.02);
    EXPECT_TRUE(found.front().both_pull);
}

TEST_F(SpectralRematching, WithoutRoundsNothingChanges) {
    tuning.n_rounds = 0;
    const Candidate start = candidate({exchanged, identity});
    const std::vector<Candidate> found = rematched(start);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].on_vertices.b_from_a, start.on_vertices.b_from_a);
}

// The tip of a limb ends halfway down a longer one, and no extremities are near enough to be matched.
TEST(SpectralRematchingOfLimbs, LandmarksAndDirectionsGuideAsWell) {
    const TriangleMesh shorter = test::three_spikes(), longer = test::with_longer_spike(shorter);
    const PreparationOptions options{.n_functions = 100, .n_samples = 300};
    const PreparedShape a = prepare(shorter, options), b = prepare(longer, options);
    Eigen::Index tip = 0, bottom = 0;
    const double end = longer.vertices.col(0).maxCoeff(&tip);
    longer.vertices.col(0).minCoeff(&bottom);
    const auto best = [&](const Priors& priors, double good_score) {
        const SampledPair pair(a, b, all_samples, CueTuning{}.radius, priors);
        Candidate start;
        start.follows_landmarks = false;
        start.on_vertices = {test::nearest_vertices(shorter.vertices, longer.vertices),
                             test::nearest_vertices(longer.vertices, shorter.vertices)};
        start.maps = between_samples(pair, start.on_vertices);
        start.refined_score = refined_score(pair, start.on_vertices, {});
        return rematch_extremities(start, pair, {.most_apart = 0, .good_score = good_score}, {},
                                   {.back_pull = 0, .n_continued_rounds = 8})
            .front();
    };
    const auto image_of_tip = [&](const Candidate& map) {
        return longer.vertices(map.on_vertices.b_from_a[at(tip)], 0);
    };
    EXPECT_LT(image_of_tip(best({}, 10)), 0.8 * end) << "or this proves nothing";
    VertexPairs both_ends;
    for (const Eigen::Index v : {tip, bottom})
        both_ends.emplace_back(static_cast<Index>(v), static_cast<Index>(v));
    Priors along_the_limb, at_both_ends = make_priors(a, b, both_ends, {});
    along_the_limb.directions_a = along_the_limb.directions_b = Eigen::Vector3d::UnitX();
    at_both_ends.pinned = false;
    for (const Priors* priors : {&along_the_limb, &at_both_ends}) {
        const Candidate found = best(*priors, 0);  // what is known is followed by a map that fits, too
        EXPECT_GT(image_of_tip(found), 0.95 * end);
        EXPECT_FALSE(found.guided_by_priors) << "in the end it is free";
    }
}

TEST_F(SpectralRematching, ExchangingTheShapesExchangesTheMaps) {
    tuning.n_rounds = 1;
    const Candidate there = rematched(candidate({exchanged, identity})).front(),
                    back = rematched(candidate({identity, exchanged})).front();
    EXPECT_NEAR(there.refined_score, back.refined_score, 0.01);
    EXPECT_NEAR(error(there), error(back), 0.01);
}

}  // namespace
}  // namespace counterpart::spectral_match
