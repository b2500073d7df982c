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
    RematchingTuning tuning{.most_apart = 10};
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

    std::vector<Candidate> rematched(const Candidate& map) const {
        return rematch_extremities(map, pair, tuning, {}, {.last_size = 100, .goes_on = false});
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

TEST_F(SpectralRematching, ExchangingTheShapesExchangesTheMaps) {
    tuning.n_rounds = 1;
    const Candidate there = rematched(candidate({exchanged, identity})).front(),
                    back = rematched(candidate({identity, exchanged})).front();
    EXPECT_NEAR(there.refined_score, back.refined_score, 0.01);
    EXPECT_NEAR(error(there), error(back), 0.01);
}

}  // namespace
}  // namespace counterpart::spectral_match
