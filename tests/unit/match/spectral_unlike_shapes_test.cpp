// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/unlike_shapes.hpp"
#include "support/spikes.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

struct SpectralUnlikeShapes : testing::Test {
    const PreparedShape shape = prepare(test::three_spikes(), {.n_functions = 100, .n_samples = 300});
    SpectralTuning tuning;

    SpectralUnlikeShapes() { tuning.unlike.n_coarse = 700; }

    // By the map of 30 functions that belongs to it.
    Candidate candidate(const SampledPair& pair, const std::vector<Index>& map) const {
        Candidate result;
        result.functional = fit_functional_maps(pair.points_a, pair.points_b, {map, map}, 30, false);
        return result;
    }

    // The identity, and what exchanges +y and -y.
    std::vector<Candidate> right_and_wrong(const SampledPair& pair) const {
        std::vector<Index> identity(at(pair.points_a.size())), exchanged;
        std::iota(identity.begin(), identity.end(), 0);
        for (const Index s : identity) {
            Eigen::Index nearest = 0;
            (pair.positions_a.rowwise() - pair.positions_a.row(s).cwiseProduct(Eigen::RowVector3f(1, -1, 1)))
                .rowwise()
                .squaredNorm()
                .minCoeff(&nearest);
            exchanged.push_back(static_cast<Index>(nearest));
        }
        return {candidate(pair, exchanged), candidate(pair, identity)};
    }

    // Mean distance of images from where they belong: the two surfaces are one.
    double error(const PairedMaps& maps) const {
        return (shape.mesh.vertices(maps.b_from_a, Eigen::all) - shape.mesh.vertices).rowwise().norm().mean();
    }
};

TEST_F(SpectralUnlikeShapes, TheRightMapComesFirstOnTheShapesThemselves) {
    const SampledPair pair(shape, shape, all_samples, CueTuning{}.radius);
    const std::vector<Candidate> found = search_unlike(right_and_wrong(pair), {}, pair, 2, tuning);
    ASSERT_EQ(found.size(), 2U);
    for (const Candidate& map : found) {
        EXPECT_EQ(map.on_vertices.b_from_a.size(), at(shape.mesh.n_vertices()));
        EXPECT_EQ(map.maps.b_from_a.size(), at(pair.points_a.size()));
    }
    EXPECT_LT(error(found[0].on_vertices), 0.02);
    EXPECT_GT(error(found[1].on_vertices), 0.05);
    EXPECT_GT(found[0].scores.total, found[1].scores.total + 0.05);
    EXPECT_GT(found[0].scores.orientation, 0.5);
    EXPECT_LT(found[1].scores.orientation, -0.5);  // and is said to be mirrored
}

TEST_F(SpectralUnlikeShapes, SmallOnesAreSearchedAsTheyAre) {
    const SampledPair pair(shape, shape, all_samples, CueTuning{}.radius);
    tuning.unlike.n_coarse = shape.mesh.n_vertices();
    EXPECT_LT(error(search_unlike(right_and_wrong(pair), {}, pair, 1, tuning).front().on_vertices), 0.02);
}

TEST_F(SpectralUnlikeShapes, WhatWasSaidCounts) {
    // The tips of the two spikes along y belong together, says a person.
    Eigen::Index top = 0, bottom = 0;
    shape.mesh.vertices.col(1).maxCoeff(&top);
    shape.mesh.vertices.col(1).minCoeff(&bottom);
    Priors priors = make_priors(
        shape, shape, VertexPairs{{static_cast<Index>(top), static_cast<Index>(bottom)}}, VertexPairs{});
    priors.tuning.weight = 10;
    const SampledPair pair(shape, shape, all_samples, CueTuning{}.radius, priors);
    const std::vector<Candidate> found = search_unlike(right_and_wrong(pair), {}, pair, 2, tuning);
    EXPECT_GT(error(found.front().on_vertices), 0.05);
    EXPECT_GT(error(found.front().on_vertices), error(found.back().on_vertices));
}

TEST_F(SpectralUnlikeShapes, WhatIsFoundWithoutLandmarksWinsOnlyWhereItFitsAndAgreesWithThem) {
    Eigen::Index top = 0, bottom = 0;
    shape.mesh.vertices.col(1).maxCoeff(&top);
    shape.mesh.vertices.col(1).minCoeff(&bottom);
    for (const bool is_true : {true, false}) {
        Priors priors = make_priors(
            shape, shape, VertexPairs{{static_cast<Index>(top), static_cast<Index>(is_true ? top : bottom)}},
            VertexPairs{});
        priors.tuning.weight = 10;
        const SampledPair pair(shape, shape, all_samples, CueTuning{}.radius, priors);
        const std::vector<Candidate> both = right_and_wrong(pair);
        std::vector<Candidate> unguided =
            search_unlike({both[1]}, {}, {shape, shape, all_samples, 0}, 1, tuning);
        const Candidate found = search_unlike({both[0]}, unguided.front(), pair, 1, tuning).front();
        if (is_true)
            EXPECT_LT(error(found.on_vertices), 0.02) << "the only map that was led is wrong";
        else
            EXPECT_GT(error(found.on_vertices), 0.05) << "the identity contradicts the landmark";
    }
}

TEST_F(SpectralUnlikeShapes, OfNothingComesNothing) {
    const SampledPair pair(shape, shape, all_samples, CueTuning{}.radius);
    EXPECT_TRUE(search_unlike({}, {}, pair, 1, tuning).empty());
}

}  // namespace
}  // namespace counterpart::spectral_match
