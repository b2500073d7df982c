// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart {
namespace {

TEST(Random, IsSplitMix64) {
    Random random(1234567);  // the values of the reference implementation
    EXPECT_EQ(random.next(), 6457827717110365317ULL);
    EXPECT_EQ(random.next(), 3203168211198807973ULL);
    EXPECT_EQ(random.next(), 9817491932198370423ULL);
}

TEST(Random, UniformStaysInItsRangeAndFillsIt) {
    Random random(1);
    double low = 1, high = 0, sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double x = random.uniform();
        low = std::min(low, x);
        high = std::max(high, x);
        sum += x;
    }
    EXPECT_GE(low, 0);
    EXPECT_LT(low, 0.001);
    EXPECT_LT(high, 1);
    EXPECT_GT(high, 0.999);
    EXPECT_NEAR(sum / 10000, 0.5, 0.02);
    for (int i = 0; i < 1000; ++i) {
        const double x = random.uniform(-3, -2);
        EXPECT_TRUE(x >= -3 && x < -2);
        EXPECT_LT(random.below(7), 7U);
    }
}

TEST(Random, ShufflePermutesEvenly) {
    Random random(2);
    std::vector<int> first(4, 0);
    for (int i = 0; i < 4000; ++i) {
        std::vector<int> items = {0, 1, 2, 3};
        random.shuffle(items);
        ++first[static_cast<std::size_t>(items[0])];
        std::sort(items.begin(), items.end());
        EXPECT_EQ(items, (std::vector<int>{0, 1, 2, 3}));
    }
    for (const int count : first) EXPECT_NEAR(count, 1000, 120);
}

}  // namespace
}  // namespace counterpart
