// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"

#include <counterpart/base/errors.hpp>

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Parallel, EveryItemOnceForAnyNumberOfThreads) {
    for (const int n_threads : {0, 1, 2, 5}) {
        std::vector<int> visits(1000, 0);
        const int answer = with_threads(n_threads, [&] {
            parallel_for(visits.size(), 16, [&](std::size_t i) { ++visits[i]; });
            return 42;
        });
        EXPECT_EQ(answer, 42);
        EXPECT_EQ(visits, std::vector<int>(1000, 1));
    }
    EXPECT_THROW(with_threads(-1, [] {}), InvalidInput);
}

TEST(Parallel, OneThreadIsOneThread) {
    with_threads(1, [] {
        EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 1);
        std::size_t next = 0;  // in order, without a race, because alone
        parallel_for(500, 1, [&](std::size_t i) { EXPECT_EQ(i, next++); });
    });
}

TEST(Parallel, ScratchIsPerThread) {
    std::atomic<int> made = 0;
    with_threads(2, [&] {
        parallel_for_with(
            1000, 1,
            [&] {
                ++made;
                return 0;
            },
            [](int& scratch, std::size_t) { ++scratch; });
    });
    EXPECT_GE(made, 1);
    EXPECT_LE(made, 2);
}

TEST(Parallel, ExceptionsReachTheCaller) {
    EXPECT_THROW(with_threads(2,
                              [] {
                                  parallel_for(100, 1, [](std::size_t i) {
                                      if (i == 37) throw InvalidInput("37");
                                  });
                              }),
                 InvalidInput);
}

}  // namespace
}  // namespace counterpart
