// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"

#include <counterpart/base/errors.hpp>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <set>
#include <string>
#include <thread>
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
    EXPECT_THROW(with_threads(1'000'000'000, [] {}), InvalidInput);  // each would have a place in memory
}

// Each item waits for all others: that ends soon only if each has a thread of its own.
TEST(Parallel, ThreadsAreRealOnAnyMachine) {
    for (const std::size_t n_threads : {2U, 3U, 8U}) {
        std::mutex mutex;
        std::condition_variable all_here;
        std::set<std::thread::id> here;
        with_threads(static_cast<int>(n_threads), [&] {
            EXPECT_EQ(threads::n_allowed(), static_cast<int>(n_threads));
            parallel_for(n_threads, 1, [&](std::size_t) {
                std::unique_lock lock(mutex);
                here.insert(std::this_thread::get_id());
                all_here.notify_all();
                all_here.wait_for(lock, std::chrono::seconds(20), [&] { return here.size() == n_threads; });
            });
        });
        EXPECT_EQ(here.size(), n_threads);
    }
}

TEST(Parallel, SeveralCallersEachHaveTheirThreads) {
    std::vector<std::thread> callers;
    for (int n_threads = 1; n_threads <= 4; ++n_threads) {
        callers.emplace_back([n_threads] {
            for (int round = 0; round < 20; ++round) {
                std::vector<int> visits(500, 0);
                with_threads(n_threads,
                             [&] { parallel_for(visits.size(), 1, [&](std::size_t i) { ++visits[i]; }); });
                EXPECT_EQ(visits, std::vector<int>(500, 1));
            }
        });
    }
    for (std::thread& caller : callers) caller.join();
}

TEST(Parallel, OneThreadIsOneThread) {
    with_threads(1, [] {
        EXPECT_EQ(threads::n_allowed(), 1);
        std::size_t next = 0;  // in order, without a race, because alone
        parallel_for(500, 1, [&](std::size_t i) { EXPECT_EQ(i, next++); });
    });
}

TEST(Parallel, BothWorksAreDoneForAnyNumberOfThreads) {
    for (const int n_threads : {0, 1, 2, 5}) {
        int first = 0, second = 0;
        with_threads(n_threads, [&] { parallel_invoke([&] { ++first; }, [&] { ++second; }); });
        EXPECT_EQ(first, 1);
        EXPECT_EQ(second, 1);
    }
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

TEST(Parallel, TheFirstOfSeveralExceptionsForAnyNumberOfThreads) {
    for (const int n_threads : {1, 2, 8}) {
        for (int round = 0; round < 20; ++round) {
            try {
                with_threads(n_threads, [] {
                    parallel_for(200, 1, [](std::size_t i) {
                        if (i % 50 == 49) throw InvalidInput(std::to_string(i));
                    });
                });
                FAIL();
            } catch (const InvalidInput& error) {
                EXPECT_STREQ(error.what(), "49");
            }
        }
    }
}

// What one work throws must not leave the other with half of its results.
TEST(Parallel, AnExceptionDoesNotAbandonTheLoopsOfOthers) {
    std::promise<void> thrown;
    std::atomic<int> n_before = 0, n_after = 0;
    const auto loop = [](std::atomic<int>& n) { parallel_for(1000, 1, [&](std::size_t) { ++n; }); };
    const auto fail = [&] {
        thrown.set_value();
        throw InvalidInput("the second");
    };
    const auto go_on = [&] {
        loop(n_before);
        thrown.get_future().wait_for(std::chrono::seconds(20));
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        loop(n_after);
    };
    EXPECT_THROW(with_threads(2, [&] { parallel_invoke(go_on, fail); }), InvalidInput);
    EXPECT_EQ(n_before, 1000);
    EXPECT_EQ(n_after, 1000);
}

}  // namespace
}  // namespace counterpart
