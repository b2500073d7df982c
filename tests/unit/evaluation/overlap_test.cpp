// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/evaluation/evaluate.hpp>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(EvaluateOverlap, CountsMissedAndInvented) {
    const GroundTruth truth = truth_from_map(VertexMap({0, 1, 2, -1, -1}, 3));
    const OverlapReport report = evaluate_overlap(VertexMap({2, -1, 2, 0, -1}, 3), truth);
    EXPECT_EQ(report.n_paired, 3);
    EXPECT_EQ(report.n_missed, 1);
    EXPECT_EQ(report.n_unpaired, 2);
    EXPECT_EQ(report.n_invented, 1);
    EXPECT_DOUBLE_EQ(report.missed, 1.0 / 3);
    EXPECT_DOUBLE_EQ(report.invented, 0.5);
    EXPECT_DOUBLE_EQ(report.iou, 0.5);
}

TEST(EvaluateOverlap, OfNothing) {
    EXPECT_DOUBLE_EQ(evaluate_overlap(VertexMap({-1, -1}, 1), {}).iou, 1);
    EXPECT_DOUBLE_EQ(evaluate_overlap(VertexMap({0, -1}, 1), {}).iou, 0);
}

TEST(EvaluateOverlap, RefusesTruthOfOtherMeshes) {
    EXPECT_THROW(evaluate_overlap(VertexMap({0}, 1), {{{1, 0}}}), InvalidInput);
}

}  // namespace
}  // namespace counterpart
