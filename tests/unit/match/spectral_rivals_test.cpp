// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/rivals.hpp"
#include "match/spectral/round_trips.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with spikes along +x, +y and -y, which differ in length.
TriangleMesh three_spikes() {
    TriangleMesh mesh = make_icosphere(4);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const auto p = mesh.vertices.row(v);
        mesh.vertices.row(v) *= 1 + 2 * std::exp(-10 * (1 - p[0])) + 1.2 * std::exp(-10 * (1 - p[1])) +
                                1.6 * std::exp(-10 * (1 + p[1]));
    }
    return mesh;
}

struct SpectralRivals : testing::Test {
    const PreparedShape shape = prepare(three_spikes(), {.n_functions = 100, .n_samples = 300});
    const SampledPair all{shape, shape, 300, CueTuning{}.radius};
    RefinementTuning refinement;
    Candidate right, wrong;  // `wrong` exchanges +y and -y

    SpectralRivals() {
        refinement.n_rounds = 2;
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
        right.scores.total = 0.59;
        wrong.scores.total = 0.6;
        right.scores.drift = wrong.scores.drift = 1;  // all rounds
    }
};

TEST_F(SpectralRivals, ASmallLeadOfAWrongMapDoesNotLast) {
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, right.maps.b_from_a);
    EXPECT_EQ(finalists[0].scores.total, 0.59);
    EXPECT_EQ(finalists[1].scores.total, 0.59) << "no more than the one that won";
    for (const Candidate& finalist : finalists)
        EXPECT_EQ(finalist.on_vertices.b_from_a.size(), static_cast<std::size_t>(shape.mesh.n_vertices()));
}

TEST_F(SpectralRivals, OnlyThoseCloseToTheBestAreRefined) {
    wrong.scores.total = 0.59 + 1.01 * RivalTuning{}.close_score;
    std::vector<Candidate> finalists{wrong, right};
    refine_rivals(finalists, all, {}, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_FALSE(finalists[0].on_vertices.b_from_a.empty());
    EXPECT_TRUE(finalists[1].on_vertices.b_from_a.empty());
}

TEST_F(SpectralRivals, NoMoreAreRefinedThanAskedFor) {
    std::vector<Candidate> finalists{wrong, right};
    RivalTuning tuning;
    tuning.n_refined = 1;
    refine_rivals(finalists, all, tuning, refinement);
    EXPECT_EQ(finalists[0].maps.b_from_a, wrong.maps.b_from_a);
    EXPECT_TRUE(finalists[1].on_vertices.b_from_a.empty());
}

TEST_F(SpectralRivals, TheIdentityReturnsWithoutTears) {
    std::vector<Index> identity(static_cast<std::size_t>(shape.mesh.n_vertices()));
    std::iota(identity.begin(), identity.end(), 0);
    EXPECT_EQ(round_trips_and_tears(shape, shape, {identity, identity}).maxCoeff(), 0);
    std::vector<Index> torn = identity;
    std::swap(torn.front(), torn.back());
    const Vector damaged = round_trips_and_tears(shape, shape, {torn, identity});
    const double apart = (shape.mesh.vertices.row(0) - shape.mesh.vertices.row(identity.back())).norm();
    EXPECT_GE(damaged[0], apart);
}

}  // namespace
}  // namespace counterpart::spectral_match
