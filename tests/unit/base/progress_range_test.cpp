// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/progress_range.hpp"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart::base {
namespace {

TEST(ProgressRange, PartsAndStepsAreShares) {
    WorkState state;
    const ProgressRange second_half = ProgressRange(state).part(0.5, 1);
    second_half.reach(0.5);
    EXPECT_DOUBLE_EQ(state.fraction, 0.75);
    second_half.step(3, 4).reach(0.5);
    EXPECT_DOUBLE_EQ(state.fraction, 0.9375);
}

TEST(ProgressRange, NeverDecreases) {
    WorkState state;
    ProgressRange(state).reach(0.6);
    ProgressRange(state).reach(0.2);
    EXPECT_DOUBLE_EQ(state.fraction, 0.6);
}

TEST(ProgressRange, ReportsFromTheCallingThreadAndEndsWithOne) {
    std::vector<double> fractions;
    const auto caller = std::this_thread::get_id();
    bool is_caller = true;
    std::thread::id worker;
    const int result = with_progress(
        [&](double fraction) {
            fractions.push_back(fraction);
            is_caller &= std::this_thread::get_id() == caller;
            return true;
        },
        [&](const ProgressRange& progress) {
            worker = std::this_thread::get_id();
            progress.reach(0.5);
            return 7;
        });
    EXPECT_EQ(result, 7);
    EXPECT_TRUE(is_caller);
    EXPECT_NE(worker, caller);
    EXPECT_GE(fractions.size(), 2U);
    EXPECT_EQ(fractions.back(), 1);
}

// As WebAssembly without threads has it.
TEST(ProgressRange, OneThreadReportsBetweenTheStepsOfItsWork) {
    const auto steps = [](const ProgressRange& progress) {
        for (int i = 1; i <= 4; ++i) {
            progress.reach(i / 4.0);
            std::this_thread::sleep_for(report_interval);
        }
        return 7;
    };
    std::vector<double> fractions;
    const auto caller = std::this_thread::get_id();
    const Progress told = [&](double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        fractions.push_back(fraction);
        return true;
    };
    EXPECT_EQ(reported_between(told, steps), 7);
    EXPECT_EQ(fractions, (std::vector<double>{0.25, 0.5, 0.75, 1}));
    int n_told = 0;
    EXPECT_THROW(reported_between([&](double) { return ++n_told < 2; }, steps), Canceled);
    EXPECT_EQ(n_told, 2);
}

TEST(ProgressRange, StopsTheWorkWhenTheCallbackSaysSoOrThrows) {
    bool has_ended = false;
    const auto work = [&](const ProgressRange& progress) {
        struct AtEnd {
            bool& flag;
            ~AtEnd() { flag = true; }
        } at_end{has_ended};
        while (true) progress.check();
        return 0;
    };
    EXPECT_THROW(with_progress([](double) { return false; }, work), Canceled);
    EXPECT_TRUE(has_ended);
    has_ended = false;
    EXPECT_THROW(with_progress([](double) -> bool { throw std::logic_error("no"); }, work), std::logic_error);
    EXPECT_TRUE(has_ended);
}

TEST(ProgressRange, PassesOnWhatTheWorkThrows) {
    const auto fails = [](const ProgressRange&) -> int { throw std::logic_error("no"); };
    EXPECT_THROW(with_progress([](double) { return true; }, fails), std::logic_error);
    EXPECT_THROW(with_progress({}, fails), std::logic_error);
}

}  // namespace
}  // namespace counterpart::base
