// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/final_choice.hpp"
#include "match/spectral/refined_score.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with spikes of other lengths along +x and -x, and one along +y.
TriangleMesh spiky_sphere() {
    TriangleMesh mesh = make_icosphere(4);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const auto p = mesh.vertices.row(v);
        const double radius = 1 + 2 * std::exp(-10 * (1 - p[0])) + 1.2 * std::exp(-10 * (1 + p[0])) +
                              2 * std::exp(-10 * (1 - p[1]));
        mesh.vertices.row(v) *= radius;
    }
    return mesh;
}

struct SpectralFinalChoice : testing::Test {
    const PreparedShape shape = prepare(spiky_sphere(), {.n_functions = 100, .n_samples = 300});
    const SampledPair pair{shape, shape, 300, CueTuning{}.radius};
    Candidate right, wrong;  // where x is large, `wrong` goes to the sample nearest to the mirrored place

    SpectralFinalChoice() {
        std::vector<Index> identity(static_cast<std::size_t>(pair.points_a.size())), exchanged;
        std::iota(identity.begin(), identity.end(), 0);
        const float far = 0.5F * pair.positions_a.col(0).cwiseAbs().maxCoeff();
        for (const Index s : identity) {
            Eigen::Index nearest = s;
            if (std::abs(pair.positions_a(s, 0)) > far)
                (pair.positions_a.rowwise() -
                 pair.positions_a.row(s).cwiseProduct(Eigen::RowVector3f(-1, 1, 1)))
                    .rowwise()
                    .squaredNorm()
                    .minCoeff(&nearest);
            exchanged.push_back(static_cast<Index>(nearest));
        }
        right.maps = {identity, identity};
        wrong.maps = {exchanged, exchanged};
        right.scores.total = 0.98;
        wrong.scores.total = 1;
    }
};

TEST_F(SpectralFinalChoice, AWrongLimbLosesItsSmallLead) {
    std::vector<Candidate> finalists{wrong, right};
    choose_best(finalists, pair, {});
    EXPECT_EQ(finalists.front().maps.b_from_a, right.maps.b_from_a);
    EXPECT_GT(finalists.front().scores.total, finalists.back().scores.total + 0.05);
}

TEST_F(SpectralFinalChoice, CuesOfTheTruthAreTheBestThereAre) {
    std::vector<Candidate> finalists{right};
    choose_best(finalists, pair, {});
    const Cues& cues = finalists.front().cues;
    for (const double correlation : cues.relief) EXPECT_GT(correlation, 0.99);
    EXPECT_LT(cues.residual, 0.01);
    EXPECT_LT(cues.wring, 0.05);
}

TEST_F(SpectralFinalChoice, OnlyAsManyAsAskedForAreTried) {
    std::vector<Candidate> finalists{wrong, right};
    FinalChoiceTuning tuning;
    tuning.n_tried = 1;
    choose_best(finalists, pair, tuning);
    ASSERT_EQ(finalists.size(), 1U);
    EXPECT_EQ(finalists.front().maps.b_from_a, wrong.maps.b_from_a);
}

TEST_F(SpectralFinalChoice, OneThatIsNotRefinedDoesNotWin) {
    std::vector<Candidate> finalists{wrong, right};
    finalists[0].scores.total = 0.5;
    finalists[1].scores.total = 0.3;
    FinalChoiceTuning tuning;
    tuning.close_score = 0;
    choose_best(finalists, pair, tuning);
    EXPECT_EQ(finalists.front().maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_GE(finalists.front().scores.total, finalists.back().scores.total);
}

TEST_F(SpectralFinalChoice, OfUnlikeShapesTheBestByEquation7ComeFirst) {
    for (Candidate* candidate : {&wrong, &right}) {
        candidate->functional = fit_functional_maps(pair.points_a, pair.points_b, candidate->maps, 30, false);
        candidate->maps = {};
    }
    SpectralTuning tuning;
    tuning.unlike.rivals.n_refined = 1;
    const std::vector<Candidate> both = choose_unlike({wrong, right}, pair, 2, tuning),
                                 one = choose_unlike({wrong, right}, pair, 1, tuning);
    ASSERT_EQ(both.size(), 2U);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(both[0].on_vertices.b_from_a, one[0].on_vertices.b_from_a);
    EXPECT_GT(refined_score(pair, both[0].on_vertices, {}), refined_score(pair, both[1].on_vertices, {}));
    double error = 0;
    for (std::size_t s = 0; s < one[0].maps.b_from_a.size(); ++s)
        error += (pair.positions_a.row(static_cast<Eigen::Index>(s)) -
                  pair.positions_b.row(one[0].maps.b_from_a[s]))
                     .norm();
    EXPECT_LT(error / static_cast<double>(one[0].maps.b_from_a.size()), 0.03);
    for (const Candidate& candidate : both) {
        EXPECT_TRUE(candidate.was_tried);
        EXPECT_FALSE(candidate.on_vertices.b_from_a.empty());
    }
    EXPECT_NEAR(both[0].scores.total - both[1].scores.total,
                refined_score(pair, both[0].on_vertices, {}) - refined_score(pair, both[1].on_vertices, {}),
                1e-12);
    EXPECT_TRUE(choose_unlike({}, pair, 1, tuning).empty());
    EXPECT_EQ(choose_unlike({right, right, wrong}, pair, 2, tuning).back().on_vertices.b_from_a,
              both[1].on_vertices.b_from_a)
        << "the same map does not count twice";
    // What scores much less than the best candidate is not tried.
    right.scores.total = wrong.scores.total - 1.01 * tuning.unlike.close_candidate;
    EXPECT_EQ(choose_unlike({wrong, right}, pair, 2, tuning).size(), 2U) << "unless it is asked for";
    const std::vector<Candidate> near = choose_unlike({wrong, right}, pair, 1, tuning);
    ASSERT_EQ(near.size(), 1U);
    EXPECT_EQ(near[0].on_vertices.b_from_a, both[1].on_vertices.b_from_a);
}

}  // namespace
}  // namespace counterpart::spectral_match
