// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/half_turn_cues.hpp"
#include "match/spectral/refined_score.hpp"
#include "support/spikes.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with spikes along +x, +y and -y, which differ in length, and its copy, turned and moved.
struct SpectralRefinedScore : testing::Test {
    static TriangleMesh turned(TriangleMesh mesh) {
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        mesh.vertices = (mesh.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(3, 1, 2);
        return mesh;
    }

    static const PreparedShape& spikes() {  // prepared once for all tests
        static const PreparedShape shape =
            prepare(test::three_spikes(3), {.n_functions = 60, .n_samples = 300});
        return shape;
    }
    static const PreparedShape& turned_spikes() {  // prepared once for all tests
        static const PreparedShape shape =
            prepare(turned(test::three_spikes(3)), {.n_functions = 60, .n_samples = 300});
        return shape;
    }
    const PreparedShape &a = spikes(), &b = turned_spikes();
    const SampledPair all{a, b, all_samples, CueTuning{}.radius};
    Candidate right, wrong;  // `wrong` exchanges +y and -y

    SpectralRefinedScore() {
        std::vector<Index> identity(static_cast<std::size_t>(a.mesh.n_vertices())), exchanged;
        std::iota(identity.begin(), identity.end(), 0);
        for (const Index v : identity) {
            Eigen::Index nearest = 0;
            const Eigen::RowVector3d mirrored =
                a.mesh.vertices.row(v).cwiseProduct(Eigen::RowVector3d(1, -1, 1));
            (a.mesh.vertices.rowwise() - mirrored).rowwise().squaredNorm().minCoeff(&nearest);
            exchanged.push_back(static_cast<Index>(nearest));
        }
        right.on_vertices = {identity, identity};
        wrong.on_vertices = {exchanged, exchanged};
    }
};

TEST_F(SpectralRefinedScore, IsLargestForTheSameShapeHoweverItIsTurned) {
    const RefinedScoreTuning tuning;
    EXPECT_NEAR(refined_score(all, right.on_vertices, tuning), 1 + tuning.normal_weight, 1e-3);
    EXPECT_LT(refined_score(all, wrong.on_vertices, tuning),
              refined_score(all, right.on_vertices, tuning) - 0.2);
}

TEST_F(SpectralRefinedScore, EachPartTellsByItself) {
    EXPECT_GT(mean_relief(relief_correlations(a, b, right.on_vertices)),
              mean_relief(relief_correlations(a, b, wrong.on_vertices)) + 0.05);
    EXPECT_NEAR(agreement_of_normals(a, b, right.on_vertices, 0.3), 1, 1e-3);
    EXPECT_LT(agreement_of_normals(a, b, wrong.on_vertices, 0.3), 0.9);
    RefinedScoreTuning tuning;
    Candidate torn = right;
    torn.on_vertices.b_from_a.front() = torn.on_vertices.b_from_a.back();
    const double before = refined_score(all, torn.on_vertices, tuning);
    tuning.damage_weight *= 2;
    EXPECT_LT(refined_score(all, torn.on_vertices, tuning), before - 1e-4);
    EXPECT_EQ(refined_score(all, right.on_vertices, tuning), refined_score(all, right.on_vertices, {}))
        << "no damage";
}

TEST_F(SpectralRefinedScore, WhatContradictsAPersonIsTakenOff) {
    Eigen::Index tip = 0;
    a.mesh.vertices.col(1).maxCoeff(&tip);
    const Priors priors =
        make_priors(a, b, {}, VertexPairs{{static_cast<Index>(tip), static_cast<Index>(tip)}});
    const SampledPair known{a, b, all_samples, CueTuning{}.radius, priors};
    const double contradiction = disagreement(a, b, priors, between_samples(known, right.on_vertices));
    EXPECT_GT(contradiction, 1);
    EXPECT_NEAR(refined_score(known, right.on_vertices, {}),
                refined_score(all, right.on_vertices, {}) - contradiction, 1e-12);
    EXPECT_EQ(refined_score(known, wrong.on_vertices, {}), refined_score(all, wrong.on_vertices, {}))
        << "takes the tip elsewhere";
}

TEST_F(SpectralRefinedScore, IsTheSameWithTheShapesExchanged) {
    const SampledPair reversed{b, a, all_samples, CueTuning{}.radius};
    Candidate back;
    back.on_vertices = {wrong.on_vertices.a_from_b, wrong.on_vertices.b_from_a};
    EXPECT_NEAR(refined_score(reversed, back.on_vertices, {}), refined_score(all, wrong.on_vertices, {}),
                1e-9);
}

}  // namespace
}  // namespace counterpart::spectral_match
