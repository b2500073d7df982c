// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/confidence.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <algorithm>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

// A ball on itself, and another fit far behind by its total that takes most of it elsewhere.
double mean_confidence_beside(double score_of_other, const ConfidenceTuning& tuning) {
    const Surface ball(make_icosphere(2), 40, {}, {}, {});
    Fit best, other;
    for (Index v = 0; v < ball.mesh.n_vertices(); ++v) best.bent.image.push_back(v);
    best.bent.positions = ball.mesh.vertices;
    best.score = 0.9;
    best.total = 1;
    other = best;
    std::reverse(other.bent.image.begin(), other.bent.image.end());
    other.score = score_of_other;
    other.total = 0.5;
    return confidence(ball, ball, {best, other}, {}, tuning).mean();
}

// What lies falsely on the other part may fit it best.
TEST(PartialConfidence, OfTwoPartsARunnerUpThatLooksAsAlikeCounts) {
    const double sure = mean_confidence_beside(0.5, confidence_of_parts);
    EXPECT_GT(sure, 0.9);
    EXPECT_LT(mean_confidence_beside(0.9, confidence_of_parts), 0.6 * sure);
    EXPECT_LT(mean_confidence_beside(0.95, confidence_of_parts), 0.6 * sure);
    EXPECT_GT(mean_confidence_beside(0.8, confidence_of_parts), 0.95 * sure);
}

TEST(PartialConfidence, OfAPartThatMustFitAsAWholeTotalsDecide) {
    EXPECT_GT(mean_confidence_beside(0.95, ConfidenceTuning{}), 0.9);
}

}  // namespace
}  // namespace counterpart::partial_match
