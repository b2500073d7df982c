// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product_search.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"

#include <counterpart/base/errors.hpp>

#include <limits>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

MatrixF random_rows(Index rows, Index columns, std::uint64_t seed) {
    Random random(seed);
    return MatrixF::NullaryExpr(rows, columns, [&] { return static_cast<float>(random.uniform(-1, 1)); });
}

BestPartners nearest(const MatrixF& x, const MatrixF& y) {
    return best_partners(x, y, x.rowwise().squaredNorm() / 2, y.rowwise().squaredNorm() / 2);
}

TEST(ProductSearch, FindsTheNearestOfBothSides) {
    for (const auto& [n, m, d] : {std::tuple{1, 1, 1}, {7, 33, 3}, {500, 261, 40}, {241, 1000, 17}}) {
        const MatrixF x = random_rows(n, d, 1), y = random_rows(m, d, 2);
        const BestPartners found = nearest(x, y);
        ASSERT_EQ(found.of_row.size(), static_cast<std::size_t>(n));
        ASSERT_EQ(found.of_column.size(), static_cast<std::size_t>(m));
        for (Index i = 0; i < n; ++i) {
            const float best = (y.rowwise() - x.row(i)).rowwise().squaredNorm().minCoeff();
            const Index j = found.of_row[static_cast<std::size_t>(i)];
            EXPECT_NEAR((y.row(j) - x.row(i)).squaredNorm(), best, 1e-4F);
        }
        for (Index j = 0; j < m; ++j) {
            const float best = (x.rowwise() - y.row(j)).rowwise().squaredNorm().minCoeff();
            const Index i = found.of_column[static_cast<std::size_t>(j)];
            EXPECT_NEAR((x.row(i) - y.row(j)).squaredNorm(), best, 1e-4F);
        }
    }
}

TEST(ProductSearch, TiesGoToTheSmallestNumber) {
    const MatrixF x = MatrixF::Ones(700, 5), y = MatrixF::Ones(90, 5);
    const BestPartners found = nearest(x, y);
    EXPECT_EQ(found.of_row, std::vector<Index>(700, 0));
    EXPECT_EQ(found.of_column, std::vector<Index>(90, 0));
}

TEST(ProductSearch, RefusesWhatIsNoNumber) {
    const MatrixF none = MatrixF::Constant(7, 5, std::numeric_limits<float>::quiet_NaN());
    EXPECT_THROW(nearest(random_rows(21, 5, 2), none), NumericalError);
}

TEST(ProductSearch, SameForAnyNumberOfThreads) {
    const MatrixF x = random_rows(1500, 30, 3), y = random_rows(1400, 30, 4);
    const BestPartners one = with_threads(1, [&] { return nearest(x, y); });
    const BestPartners three = with_threads(3, [&] { return nearest(x, y); });
    EXPECT_EQ(one.of_row, three.of_row);
    EXPECT_EQ(one.of_column, three.of_column);
}

}  // namespace
}  // namespace counterpart::numerics
