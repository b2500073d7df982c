// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/confidence.hpp"
#include "support/messages.hpp"

#include <counterpart/mesh/shapes.hpp>

#include <gtest/gtest.h>

namespace counterpart::partial_match {
namespace {

// A map that looks right, without doubt.
PartialResult plain_result() {
    PartialResult result;
    result.target_from_source = result.source_from_target = identity_map(10);
    result.confidence = Vector::Constant(10, 0.9);
    result.part = Part::both;
    result.score = 0.8;
    result.source_share = result.target_share = 0.6;
    return result;
}

std::vector<Message> said(const PartialResult& result, double misfit = 0,
                          const std::optional<Elsewhere>& elsewhere = {}) {
    return messages_on(result, {}, {}, misfit, elsewhere, {});
}

TEST(PartialMessages, OfAPlainResultThereAreNone) { EXPECT_EQ(test::lines_of(said(plain_result())), ""); }

// Another fit that takes nothing elsewhere is no other fit, however near its score.
TEST(PartialMessages, ARunnerUpCountsOnlyWhereItGoesElsewhere) {
    const Surface ball(make_icosphere(2), 40, {}, {}, {});
    Fit best, same, other;
    best.total = 1;
    same.total = 0.999;
    other.total = 0.99;
    for (Index v = 0; v < 100; ++v) best.bent.image.push_back(v);
    same.bent.image = best.bent.image;
    other.bent.image = {best.bent.image.rbegin(), best.bent.image.rend()};
    EXPECT_FALSE(best_elsewhere({best, same}, ball, {}).has_value());
    const auto found = best_elsewhere({best, same, other}, ball, {});
    ASSERT_TRUE(found.has_value());
    EXPECT_NEAR(found->behind, 0.01, 1e-12);
    EXPECT_GT(found->moved, 0.5);

    PartialResult result = plain_result();
    result.margin = 0.001;
    EXPECT_FALSE(contains(said(result), MessageCode::close_runner_up));
    EXPECT_TRUE(contains(said(result, 0, found), MessageCode::close_runner_up));
    EXPECT_FALSE(contains(said(result, 0, Elsewhere{0.5, 0.2, 0.9}), MessageCode::close_runner_up));
}

// Pelvis and femora: all of the target is found, and what the source has besides lies there too.
TEST(PartialMessages, WhatFitsNothingIsNoDoubtWhereAllOfTheOtherMeshFits) {
    PartialResult result = plain_result();
    EXPECT_EQ(gravest(said(result, 0.28)), Severity::caution);
    result.target_share = 1;
    EXPECT_EQ(gravest(said(result, 0.28)), Severity::notice);
    EXPECT_TRUE(contains(said(result, 0.28), MessageCode::misfit));
}

}  // namespace
}  // namespace counterpart::partial_match
