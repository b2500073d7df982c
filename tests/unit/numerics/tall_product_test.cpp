// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/tall_product.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"

#include <tuple>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

Eigen::MatrixXd random_columns(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
    Random random(seed);
    return Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return random.uniform(-1, 1); });
}

TEST(TallProduct, IsTheProduct) {
    for (const auto& [rows, inner, columns] : {std::tuple{1, 1, 1},
                                               {5000, 70, 8},
                                               {2049, 9, 13},
                                               {273, 130, 200},
                                               {0, 3, 8},
                                               {40, 0, 8},
                                               {40, 3, 0}}) {
        const Eigen::MatrixXd a = random_columns(rows, inner, 1), b = random_columns(inner, columns, 2),
                              c = random_columns(rows, columns, 3);
        const Eigen::MatrixXd product = times(a, b), transposed = transposed_times(a, c);
        ASSERT_EQ(product.rows(), rows);
        ASSERT_EQ(product.cols(), columns);
        ASSERT_EQ(transposed.rows(), inner);
        ASSERT_EQ(transposed.cols(), columns);
        EXPECT_TRUE(product.isApprox(a * b, 1e-12)) << rows << " " << inner << " " << columns;
        EXPECT_TRUE(transposed.isApprox(a.transpose() * c, 1e-12)) << rows << " " << inner << " " << columns;
    }
}

TEST(TallProduct, TakesPartsOfLargerMatrices) {
    const Eigen::MatrixXd a = random_columns(300, 40, 1), b = random_columns(20, 8, 2);
    EXPECT_EQ(times(a.middleCols(7, 20), b), times(Eigen::MatrixXd(a.middleCols(7, 20)), b));
    const Eigen::MatrixXd c = random_columns(300, 8, 3);
    EXPECT_EQ(transposed_times(a.middleCols(7, 20), c),
              transposed_times(Eigen::MatrixXd(a.middleCols(7, 20)), c));
}

TEST(TallProduct, SameForAnyNumberOfThreads) {
    const Eigen::MatrixXd a = random_columns(3000, 200, 4), b = random_columns(200, 24, 5),
                          c = random_columns(3000, 24, 6);
    const auto both = [&] { return std::pair(times(a, b), transposed_times(a, c)); };
    EXPECT_EQ(with_threads(1, both), with_threads(4, both));
}

}  // namespace
}  // namespace counterpart::numerics
