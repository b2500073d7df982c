// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/map.hpp"
#include "match/spectral/score.hpp"
#include "support/spikes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace counterpart::spectral_match {
namespace {

// A sphere with spikes along +x, +y and -y, which differ in length, and its copy, turned and moved.
class SpectralScore : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        const PreparationOptions options{.n_functions = 40, .n_samples = 200};
        TriangleMesh mesh = test::three_spikes(3);
        a = std::make_unique<PreparedShape>(prepare(mesh, options));
        const Eigen::Matrix3d turn =
            Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
        mesh.vertices = (mesh.vertices * turn.transpose()).rowwise() + Eigen::RowVector3d(3, 1, 2);
        b = std::make_unique<PreparedShape>(prepare(mesh, options));
    }
    static void TearDownTestSuite() {
        a.reset();
        b.reset();
    }

    PairedMaps both_ways(const std::vector<Index>& map) const { return {map, map}; }
    Score score_of(const PairedMaps& maps, const Priors& priors = nothing_known) const {
        return score(Level(*a, *b, priors, tuning), maps);
    }

    static inline std::unique_ptr<const PreparedShape> a, b;
    SpectralTuning tuning;
    const PairedMaps right = both_ways(test::staying(a->mesh)), wrong = both_ways(test::exchanged(a->mesh));
};

TEST_F(SpectralScore, IsLargestForTheSameShapeHoweverItIsTurned) {
    const Score best = score_of(right);
    EXPECT_NEAR(best.relief, 1, 1e-3);
    EXPECT_NEAR(best.normals, 1, 1e-3);
    EXPECT_EQ(best.damage, 0);
    EXPECT_EQ(best.disagreement, 0);
    EXPECT_NEAR(best.total, 1 + tuning.score.normal_weight, 1e-3);
    EXPECT_LT(score_of(wrong).total, best.total - 0.2);
}

TEST_F(SpectralScore, EachTermTellsByItself) {
    const Score best = score_of(right), other = score_of(wrong);
    EXPECT_LT(other.relief, best.relief - 0.05);
    EXPECT_LT(other.normals, 0.9);
    PairedMaps torn = right;
    torn.b_from_a.front() = torn.b_from_a.back();
    EXPECT_GT(score_of(torn).damage, 1e-4);
}

TEST_F(SpectralScore, IsTheWeightedSumOfItsTerms) {
    tuning.score.normal_weight = 0.7;
    tuning.score.damage_weight = 3;
    const Priors priors = make_priors(*a, *b, VertexPairs{{0, 600}}, {});
    const Score other = score_of(wrong, priors);
    ASSERT_GT(other.damage, 1e-4);
    ASSERT_GT(other.disagreement, 0.1);
    EXPECT_NEAR(other.total, other.relief + 0.7 * other.normals - 3 * other.damage - other.disagreement,
                1e-12);
}

TEST_F(SpectralScore, WhatContradictsAPersonIsTakenOff) {
    Eigen::Index tip = 0;
    a->mesh.vertices.col(1).maxCoeff(&tip);
    const Priors priors =
        make_priors(*a, *b, {}, VertexPairs{{static_cast<Index>(tip), static_cast<Index>(tip)}});
    EXPECT_GT(score_of(right, priors).disagreement, 1);
    EXPECT_NEAR(score_of(right, priors).total, score_of(right).total - score_of(right, priors).disagreement,
                1e-12);
    EXPECT_EQ(score_of(wrong, priors).total, score_of(wrong).total) << "takes the tip elsewhere";
}

TEST_F(SpectralScore, IsTheSameWithTheShapesExchanged) {
    const PairedMaps one_sided{right.b_from_a, wrong.a_from_b};
    const Score there = score_of(one_sided),
                back = score(Level(*b, *a, nothing_known, tuning), reversed(one_sided));
    EXPECT_NEAR(there.relief, back.relief, 1e-12);
    EXPECT_NEAR(there.normals, back.normals, 1e-12);
    EXPECT_NEAR(there.damage, back.damage, 1e-12);
    EXPECT_NEAR(there.total, back.total, 1e-12);
}

TEST_F(SpectralScore, WhatIsNotANumberNeverWins) {
    PreparedShape broken = *b;
    broken.normals(a->samples.front(), 0) = std::numeric_limits<double>::quiet_NaN();
    const Level level(*a, broken, nothing_known, tuning);
    EXPECT_EQ(score(level, right).total, -std::numeric_limits<double>::infinity());
}

TEST_F(SpectralScore, OfAMapIsThatOfItsVertices) {
    const Level level(*a, *b, nothing_known, tuning);
    const Map map = scored(level, wrong);
    EXPECT_EQ(map.rank(), score(level, wrong).total);
    EXPECT_EQ(map.on_vertices.b_from_a, wrong.b_from_a);
    ASSERT_EQ(map.maps.b_from_a.size(), a->samples.size());
    for (std::size_t s = 0; s < a->samples.size(); ++s)
        EXPECT_EQ(map.maps.b_from_a[s], b->cell_of_vertex[at(wrong.b_from_a[at(a->samples[s])])]);
}

TEST_F(SpectralScore, OnlyTheLongWayOfAnEdgeIsATear) {
    const LevelShape shape(*a, tuning);
    EXPECT_EQ(round_trips_and_tears(shape, shape, right).maxCoeff(), 0);
    PairedMaps torn = right;
    torn.b_from_a.front() = torn.b_from_a.back();
    const Vector damaged = round_trips_and_tears(shape, shape, torn);
    const auto place = [&](Index v) { return a->mesh.vertices.row(v); };
    const Index far = torn.b_from_a.back();
    double largest = 0;
    for (const Index w : shape.neighbors.neighbors(0)) {
        const double tear = (place(w) - place(far)).norm() - 2 * (place(w) - place(0)).norm();
        EXPECT_NEAR(damaged[w], tear, 1e-12);
        largest = std::max(largest, tear);
    }
    EXPECT_NEAR(damaged[0], (place(0) - place(far)).norm() + largest, 1e-12)
        << "the way there and back, and the tear";
}

}  // namespace
}  // namespace counterpart::spectral_match
