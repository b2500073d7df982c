// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/assignment.hpp"

#include "base/random.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace counterpart::numerics {
namespace {

// The cost of an assignment; fails unless it is one-to-one and complete on the smaller side.
double checked_total(const Matrix& cost, const std::vector<Index>& column_of_row) {
    EXPECT_EQ(static_cast<Eigen::Index>(column_of_row.size()), cost.rows());
    std::vector<bool> taken(static_cast<std::size_t>(cost.cols()), false);
    double total = 0;
    Eigen::Index assigned = 0;
    for (Eigen::Index row = 0; row < cost.rows(); ++row) {
        const Index column = column_of_row[static_cast<std::size_t>(row)];
        if (column < 0) continue;
        EXPECT_LT(column, cost.cols());
        EXPECT_FALSE(taken[static_cast<std::size_t>(column)]) << "column " << column << " is taken twice";
        taken[static_cast<std::size_t>(column)] = true;
        total += cost(row, column);
        ++assigned;
    }
    EXPECT_EQ(assigned, std::min(cost.rows(), cost.cols()));
    return total;
}

// Oracle: every injective choice of columns, rows <= columns.
double least_total(const Matrix& cost) {
    if (cost.rows() > cost.cols()) return least_total(cost.transpose());
    std::vector<Index> columns(static_cast<std::size_t>(cost.cols()));
    std::iota(columns.begin(), columns.end(), 0);
    double least = std::numeric_limits<double>::infinity();
    do {
        double total = 0;
        for (Eigen::Index row = 0; row < cost.rows(); ++row)
            total += cost(row, columns[static_cast<std::size_t>(row)]);
        least = std::min(least, total);
    } while (std::next_permutation(columns.begin(), columns.end()));
    return least;
}

// Costs of several kinds: reals, few distinct integers (many ties), negative, squared distances on a line.
Matrix random_cost(Random& random, Eigen::Index rows, Eigen::Index columns, int kind) {
    Matrix cost(rows, columns);
    Vector x(rows), y(columns);
    for (double& value : x) value = random.uniform();
    for (double& value : y) value = random.uniform();
    for (Eigen::Index i = 0; i < rows; ++i) {
        for (Eigen::Index j = 0; j < columns; ++j) {
            if (kind == 0) cost(i, j) = random.uniform();
            if (kind == 1) cost(i, j) = static_cast<double>(random.below(3));
            if (kind == 2) cost(i, j) = random.uniform(-5, 1);
            if (kind == 3) cost(i, j) = (x[i] - y[j]) * (x[i] - y[j]);
        }
    }
    return cost;
}

TEST(Assignment, RefusesWhatIsNotFinite) {
    for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1e300}) {
        Matrix cost = Matrix::Ones(2, 3);
        cost(1, 2) = bad;
        EXPECT_THROW(solve_assignment(cost), InvalidInput);
    }
}

TEST(Assignment, EmptyAndSingle) {
    EXPECT_TRUE(solve_assignment(Matrix(0, 3)).empty());
    EXPECT_EQ(solve_assignment(Matrix(2, 0)), (std::vector<Index>{-1, -1}));
    EXPECT_EQ(solve_assignment(Matrix::Constant(1, 1, 7)), (std::vector<Index>{0}));
    Matrix row(1, 3), column(3, 1);
    row << 3, -1, 2;
    column << 3, -1, 2;
    EXPECT_EQ(solve_assignment(row), (std::vector<Index>{1}));
    EXPECT_EQ(solve_assignment(column), (std::vector<Index>{-1, 0, -1}));
}

TEST(Assignment, IsTheBestOfAllPermutations) {
    Random random(1);
    for (int round = 0; round < 400; ++round) {
        const auto rows = static_cast<Eigen::Index>(1 + random.below(6));
        const auto columns = static_cast<Eigen::Index>(1 + random.below(6));
        const Matrix cost = random_cost(random, rows, columns, round % 4);
        EXPECT_NEAR(checked_total(cost, solve_assignment(cost)), least_total(cost), 1e-12)
            << rows << " x " << columns << "\n"
            << cost;
    }
}

// Large problems with a known answer: reduced costs u + v + w with w = 0 on a hidden permutation, positive
// elsewhere.
TEST(Assignment, FindsAHiddenPermutation) {
    Random random(2);
    for (const Index n : {50, 300}) {
        std::vector<Index> hidden(static_cast<std::size_t>(n));
        std::iota(hidden.begin(), hidden.end(), 0);
        random.shuffle(hidden);
        Vector u(n), v(n);
        for (double& value : u) value = random.uniform(-10, 10);
        for (double& value : v) value = random.uniform(-10, 10);
        Matrix cost(n, n);
        for (Index i = 0; i < n; ++i)
            for (Index j = 0; j < n; ++j)
                cost(i, j) =
                    u[i] + v[j] + (hidden[static_cast<std::size_t>(i)] == j ? 0 : random.uniform(0.01, 1));
        EXPECT_EQ(solve_assignment(cost), hidden);
    }
}

// The same optimum whichever side is the rows, and with more columns than rows when the spare columns are
// dear.
TEST(Assignment, LargeRectanglesAgreeWithTheirTransposeAndPadding) {
    Random random(3);
    for (int kind = 0; kind < 4; ++kind) {
        const Matrix cost = random_cost(random, 90, 140, kind);
        const double total = checked_total(cost, solve_assignment(cost));
        const Matrix transposed = cost.transpose();
        EXPECT_NEAR(checked_total(transposed, solve_assignment(transposed)), total, 1e-9);
        Matrix padded = Matrix::Zero(140, 140);  // 50 rows that cost nothing wherever they go
        padded.topRows(90) = cost;
        EXPECT_NEAR(checked_total(padded, solve_assignment(padded)), total, 1e-9);
    }
}

TEST(Assignment, EqualCostsEverywhere) {
    const Matrix cost = Matrix::Constant(60, 60, 0.1);
    EXPECT_NEAR(checked_total(cost, solve_assignment(cost)), 6.0, 1e-12);
}

TEST(Assignment, CanBeCanceled) {
    const Matrix cost = Matrix::Random(40, 40);
    EXPECT_THROW(solve_assignment(cost, [](double) { return false; }), Canceled);
}

}  // namespace
}  // namespace counterpart::numerics
