// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/median.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

TEST(Median, IsKnownOfSmallLists) {
    EXPECT_EQ(median(std::vector<double>{}), 0);
    EXPECT_EQ(median(std::vector<double>{5, 1, 9}), 5);
    EXPECT_EQ(median(std::vector<float>{4, 1, 3, 2}), 3);
    EXPECT_EQ(median_absolute_deviation({}), 0);
    EXPECT_EQ(median_absolute_deviation({1, 2, 4, 100, 3}), 1);
    EXPECT_EQ(median_absolute_deviation({7, 7, 7}), 0);
}

}  // namespace
}  // namespace counterpart::numerics
