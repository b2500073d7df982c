// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/rank_correlation.hpp"

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

TEST(RankCorrelation, IsKnownOfSmallLists) {
    const Vector rising{{1, 2, 3, 4, 5}}, fast{{1, 10, 100, 1000, 10000}}, mixed{{2, 1, 4, 3, 5}};
    EXPECT_DOUBLE_EQ(rank_correlation(rising, fast), 1);
    EXPECT_DOUBLE_EQ(rank_correlation(rising, -fast), -1);
    EXPECT_DOUBLE_EQ(rank_correlation(rising, mixed), 1 - 6.0 * 4 / (5 * 24));  // 1 - 6 sum d^2 / (n^3 - n)
    EXPECT_EQ(rank_correlation(Vector{{1}}, Vector{{1}}), 0);
}

}  // namespace
}  // namespace counterpart::numerics
