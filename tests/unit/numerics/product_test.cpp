// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/product.hpp"

#include "base/parallel.hpp"
#include "base/random.hpp"

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

MatrixF random_matrix(Index rows, Index columns, std::uint64_t seed) {
    Random random(seed);
    return MatrixF::NullaryExpr(rows, columns, [&] { return static_cast<float>(random.uniform(-1, 1)); });
}

void expect_close(const MatrixF& found, const Eigen::MatrixXd& expected) {
    ASSERT_EQ(found.rows(), expected.rows());
    ASSERT_EQ(found.cols(), expected.cols());
    if (found.size() > 0) {
        EXPECT_LT((found.cast<double>() - expected).cwiseAbs().maxCoeff(), 1e-3);
    }
}

TEST(Product, IsThatOfDoublePrecision) {
    for (const auto& [rows, inner, columns] :
         {std::tuple{1, 1, 1}, {6, 3, 32}, {7, 600, 33}, {100, 0, 5}, {0, 4, 4}, {13, 257, 70}}) {
        const MatrixF a = random_matrix(rows, inner, 1), b = random_matrix(inner, columns, 2);
        const Eigen::MatrixXd expected = a.cast<double>() * b.cast<double>();
        expect_close(product(a, b), expected);
        expect_close(transposed_product(a.transpose(), b), expected);
    }
}

TEST(Product, SameForAnyNumberOfThreads) {
    const MatrixF a = random_matrix(300, 500, 3), b = random_matrix(500, 200, 4);
    const MatrixF one = with_threads(1, [&] { return product(a, b); });
    EXPECT_EQ(one, with_threads(4, [&] { return product(a, b); }));
}

}  // namespace
}  // namespace counterpart::numerics
