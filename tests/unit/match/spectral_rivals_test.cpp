// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rivals.hpp"
#include "match/spectral/round_trips.hpp"
#include "support/spikes.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

struct SpectralRivals : testing::Test {
    const PreparedShape shape = prepare(test::three_spikes(), {.n_functions = 100, .n_samples = 300});
    const SampledPair all{shape, shape, 300, CueTuning{}.radius};
    RefinementTuning refinement;
    Candidate right, wrong;  // `wrong` exchanges +y and -y

    SpectralRivals() {
        refinement.n_rounds = 2;
        refinement.goes_on = false;
        std::vector<Index> identity(static_cast<std::size_t>(all.points_a.size())), exchanged;
        std::iota(identity.begin(), identity.end(), 0);
        for (const Index s : identity) {
            Eigen::Index nearest = 0;
            (all.positions_a.rowwise() - all.positions_a.row(s).cwiseProduct(Eigen::RowVector3f(1, -1, 1)))
                .rowwise()
                .squaredNorm()
                .minCoeff(&nearest);
            exchanged.push_back(static_cast<Index>(nearest));
        }
        right.maps = {identity, identity};
        wrong.maps = {exchanged, exchanged};
        right.was_tried = wrong.was_tried = true;
        right.scores.total = 0.59;
        wrong.scores.total = 0.6;
    }
};

// Mean distance between vertices and their images: 0 for the identity.
double error(const Candidate& candidate, const PreparedShape& shape) {
    const Points images = shape.mesh.vertices(candidate.on_vertices.b_from_a, Eigen::all);
    return (images - shape.mesh.vertices).rowwise().norm().mean();
}

TEST_F(SpectralRivals, ASmallLeadOfAWrongMapDoesNotLast) {
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement);
    ASSERT_EQ(finalists.size(), 2U);
    EXPECT_LT(error(finalists[0], shape), 0.02);
    EXPECT_GT(error(finalists[1], shape), 0.05);
    EXPECT_EQ(finalists[0].scores.total, 0.59);
    EXPECT_LT(finalists[1].scores.total, 0.58) << "less by more than the lead it had";
    EXPECT_NE(finalists[1].maps.b_from_a, wrong.maps.b_from_a) << "as it is once refined";
}

TEST_F(SpectralRivals, OnlyThoseCloseToTheBestAreRefined) {
    wrong.scores.total = 0.59 + 1.01 * RivalTuning{}.close_score;
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_FALSE(finalists[0].on_vertices.b_from_a.empty());
    EXPECT_TRUE(finalists[1].on_vertices.b_from_a.empty());
    EXPECT_EQ(finalists[1].scores.total, 0.59);
}

TEST_F(SpectralRivals, WhatWasNotTriedBeforeCannotWin) {
    right.was_tried = false;
    right.scores.total = wrong.scores.total;
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_TRUE(finalists[1].on_vertices.b_from_a.empty());
}

// The start is shifted by a few samples, which one refinement of few rounds does not mend.
TEST_F(SpectralRivals, TheWinnerIsRefinedAgainWhileThatGains) {
    for (std::vector<Index>* map : {&right.maps.b_from_a, &right.maps.a_from_b})
        for (Index& image : *map) {
            Eigen::Index shifted = 0;
            const Eigen::RowVector3f to = all.positions_a.row(image) + Eigen::RowVector3f(0, 0, 0.15F);
            (all.positions_a.rowwise() - to).rowwise().squaredNorm().minCoeff(&shifted);
            image = static_cast<Index>(shifted);
        }
    const auto error_after = [&](const std::vector<std::size_t>& n_repeated) {
        RivalTuning tuning;
        tuning.n_repeated = n_repeated;
        std::vector<Candidate> finalists{right};
        refine_rivals(finalists, all, tuning, refinement);
        EXPECT_EQ(finalists[0].scores.total, right.scores.total) << "repeating does not make it surer";
        return error(finalists[0], shape);
    };
    const double once = error_after({});
    EXPECT_LT(error_after({1, 1, 1}), 0.9 * once);
}

TEST_F(SpectralRivals, BothMapsFinallyPullAtTheWinner) {
    std::vector<Candidate> finalists{wrong, right};
    RivalTuning tuning;
    refine_rivals(finalists, all, tuning, refinement);
    EXPECT_FALSE(finalists[0].both_pull);
    const double before = finalists[0].refined_score;
    tuning.n_pull_rounds = 2;
    finalists = {wrong, right};
    refine_rivals(finalists, all, tuning, refinement);
    ASSERT_EQ(finalists.size(), 2U);
    EXPECT_LT(error(finalists[0], shape), 0.02);
    EXPECT_TRUE(finalists[0].both_pull);
    EXPECT_FALSE(finalists[1].both_pull);
    EXPECT_GE(finalists[0].refined_score, before) << "only taken where it gains";
}

TEST_F(SpectralRivals, NoMoreAreRefinedThanAskedFor) {
    std::vector<Candidate> finalists{wrong, right};
    RivalTuning tuning;
    tuning.n_refined = 1;
    refine_rivals(finalists, all, tuning, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_TRUE(finalists[1].on_vertices.b_from_a.empty());
}

TEST_F(SpectralRivals, OfThoseThatBecomeTheSameMapOneIsLeft) {
    Candidate again = right;
    again.scores.total = 0.585;
    std::vector<Candidate> finalists{wrong, right, again};
    refine_rivals(finalists, all, {}, refinement);
    ASSERT_EQ(finalists.size(), 2U);
    EXPECT_LT(error(finalists[0], shape), 0.02);
    EXPECT_GT(error(finalists[1], shape), 0.05);
}

TEST_F(SpectralRivals, ARunnerUpThatIsTheSameMapIsDroppedThoughItWasNotRefined) {
    Candidate again = right;
    again.scores.total = right.scores.total - 1.01 * RivalTuning{}.close_score;
    std::vector<Candidate> finalists{right, again};
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_EQ(finalists.size(), 1U);
}

TEST_F(SpectralRivals, ThoseThatWereLeftOutScoreNoMoreThanTheWinner) {
    Candidate other = wrong;
    other.was_tried = false;
    std::vector<Candidate> finalists{wrong, other, right};
    for (Index& image : finalists[1].maps.b_from_a) image = 0;
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_LT(error(finalists[0], shape), 0.02);
    EXPECT_EQ(finalists[0].scores.total, 0.59);
    ASSERT_EQ(finalists.size(), 3U);
    EXPECT_EQ(finalists[1].scores.total, 0.59);
    EXPECT_FALSE(finalists[1].was_tried);
}

TEST_F(SpectralRivals, WhatAPersonHasSaidCountsInFull) {
    Eigen::Index tip = 0;
    shape.mesh.vertices.col(1).maxCoeff(&tip);
    const Priors priors =
        make_priors(shape, shape, {}, VertexPairs{{static_cast<Index>(tip), static_cast<Index>(tip)}});
    const SampledPair known(shape, shape, 300, CueTuning{}.radius, priors);
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, known, {}, refinement);
    EXPECT_GT(error(finalists[0], shape), 0.05) << "the identity was excluded";
}

TEST_F(SpectralRivals, ProgressEndsAtItsEndAndCanBeCanceled) {
    WorkState state;
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement, ProgressRange(state, 0, 0.9));
    EXPECT_GT(state.fraction, 0.6);
    EXPECT_LE(state.fraction, 0.9);
    state.canceled = true;
    finalists = {wrong, right};
    EXPECT_THROW(refine_rivals(finalists, all, {}, refinement, ProgressRange(state)), Canceled);
}

TEST_F(SpectralRivals, OnlyTheLongWayOfAnEdgeIsATear) {
    std::vector<Index> identity(static_cast<std::size_t>(shape.mesh.n_vertices()));
    std::iota(identity.begin(), identity.end(), 0);
    EXPECT_EQ(round_trips_and_tears(shape, shape, {identity, identity}).maxCoeff(), 0);
    std::vector<Index> torn = identity;
    torn.front() = identity.back();
    const Vector damaged = round_trips_and_tears(shape, shape, {torn, identity});
    const auto at = [&](Index v) { return shape.mesh.vertices.row(v); };
    const Index far = identity.back();
    const Adjacency adjacency(shape.mesh);
    double largest = 0;
    for (const Index w : adjacency.neighbors(0)) {
        const double tear = (at(w) - at(far)).norm() - 2 * (at(w) - at(0)).norm();
        EXPECT_NEAR(damaged[w], tear, 1e-12);
        largest = std::max(largest, tear);
    }
    EXPECT_NEAR(damaged[0], (at(0) - at(far)).norm() + largest, 1e-12)
        << "the way there and back, and the tear";
}

}  // namespace
}  // namespace counterpart::spectral_match
