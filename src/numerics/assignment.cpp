// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// R. Jonker, A. Volgenant, "A shortest augmenting path algorithm for dense and sparse linear assignment
// problems", Computing 38 (1987). Prices v of the columns keep every assigned pair at its row's smallest
// reduced cost c(i, j) - v(j). With fewer rows than columns, a free column must keep the price 0 and no price
// may be positive, so column reduction, which prices free columns, is for square costs only.
#include "numerics/assignment.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

namespace counterpart::numerics {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The assignment while it grows; rows <= columns.
class Assignment {
  public:
    explicit Assignment(const Matrix& cost)
        : cost_(cost),
          n_rows_(static_cast<Index>(cost.rows())),
          n_columns_(static_cast<Index>(cost.cols())),
          price_(Vector::Zero(n_columns_)),
          column_of_(static_cast<std::size_t>(n_rows_), -1),
          row_of_(static_cast<std::size_t>(n_columns_), -1) {}

    std::vector<Index> solve(const Progress& progress) {
        if (n_rows_ == n_columns_) reduce_columns();
        for (int pass = 0; pass < 2; ++pass) reduce_rows();
        const std::vector<Index> free = free_rows();
        for (std::size_t i = 0; i < free.size(); ++i) {
            if (i % 64 == 0)
                report_progress(progress, static_cast<double>(i) / static_cast<double>(free.size()));
            augment(free[i]);
        }
        report_progress(progress, 1);
        return std::move(column_of_);
    }

  private:
    struct TwoSmallest {
        Index first = -1, second = -1;
        double first_cost = infinity, second_cost = infinity;
    };

    double reduced(Index row, Index column) const { return cost_(row, column) - price_[column]; }
    Index& column_of(Index row) { return column_of_[static_cast<std::size_t>(row)]; }
    Index& row_of(Index column) { return row_of_[static_cast<std::size_t>(column)]; }
    void assign(Index row, Index column) {
        column_of(row) = column;
        row_of(column) = row;
    }

    std::vector<Index> free_rows() {
        std::vector<Index> free;
        for (Index row = 0; row < n_rows_; ++row)
            if (column_of(row) < 0) free.push_back(row);
        return free;
    }

    // Each column's price is its smallest cost; it takes that row if still free. A row chosen by one column
    // only then hands its slack over to the price, which makes later paths shorter.
    void reduce_columns() {
        std::vector<Index> cheapest(static_cast<std::size_t>(n_columns_), 0);
        price_ = cost_.row(0).transpose();
        for (Index row = 1; row < n_rows_; ++row) {
            for (Index column = 0; column < n_columns_; ++column) {
                if (cost_(row, column) >= price_[column]) continue;
                price_[column] = cost_(row, column);
                cheapest[static_cast<std::size_t>(column)] = row;
            }
        }
        std::vector<int> times_chosen(static_cast<std::size_t>(n_rows_), 0);
        for (Index column = n_columns_ - 1; column >= 0; --column) {
            const Index row = cheapest[static_cast<std::size_t>(column)];
            if (++times_chosen[static_cast<std::size_t>(row)] == 1) assign(row, column);
        }
        for (Index row = 0; row < n_rows_; ++row) {
            if (times_chosen[static_cast<std::size_t>(row)] != 1 || n_columns_ == 1) continue;
            const TwoSmallest two = two_smallest(row);
            const Index own = column_of(row);
            price_[own] -= (two.first == own ? two.second_cost : two.first_cost) - reduced(row, own);
        }
    }

    TwoSmallest two_smallest(Index row) const {
        TwoSmallest two;
        for (Index column = 0; column < n_columns_; ++column) {
            const double cost = reduced(row, column);
            if (cost >= two.second_cost) continue;
            if (cost < two.first_cost) {
                two.second = std::exchange(two.first, column);
                two.second_cost = std::exchange(two.first_cost, cost);
            } else {
                two.second = column;
                two.second_cost = cost;
            }
        }
        return two;
    }

    // Every free row takes its cheapest column, lowering the price to the second cheapest, and drives out
    // whoever held it; who was driven out goes next, as long as prices fall by more than rounding.
    void reduce_rows() {
        if (n_columns_ == 1) return;
        for (Index row : free_rows()) {
            // Bounds the auctions between equals, which can be long: the augmentation is there for the rest.
            for (Index step = 0; step < n_columns_ && row >= 0; ++step) {
                const TwoSmallest two = two_smallest(row);
                const double lowered = price_[two.first] - (two.second_cost - two.first_cost);
                const bool falls = lowered < price_[two.first];
                const Index column = falls || row_of(two.first) < 0 ? two.first : two.second;
                if (!falls && row_of(column) >= 0) break;
                if (falls) price_[column] = lowered;
                const Index driven_out = row_of(column);
                if (driven_out >= 0) column_of(driven_out) = -1;
                assign(row, column);
                row = driven_out;
            }
        }
    }

    // Dijkstra over the columns from a free row to the nearest free column, then flips the path.
    void augment(Index start) {
        std::vector<Index> open(static_cast<std::size_t>(n_columns_));
        for (Index i = 0; i < n_columns_; ++i) open[static_cast<std::size_t>(i)] = i;
        std::vector<Index> settled, previous_row(static_cast<std::size_t>(n_columns_), start);
        Vector distance = Vector::Constant(n_columns_, infinity);

        double base = 0;  // distance of `row` minus its own reduced cost
        double reached = 0;
        Index row = start, end = -1;
        while (end < 0) {
            std::size_t nearest = 0;
            reached = infinity;
            for (std::size_t i = 0; i < open.size(); ++i) {
                const Index column = open[i];
                const double through = base + reduced(row, column);
                if (through < distance[column]) {
                    distance[column] = through;
                    previous_row[static_cast<std::size_t>(column)] = row;
                }
                // A free column ends the search: prefer it among equals.
                const double d = distance[column];
                if (d < reached || (d == reached && row_of(column) < 0 && row_of(open[nearest]) >= 0)) {
                    reached = d;
                    nearest = i;
                }
            }
            const Index column = open[nearest];
            if (row_of(column) < 0) {
                end = column;
            } else {
                settled.push_back(column);
                open[nearest] = open.back();
                open.pop_back();
                row = row_of(column);
                base = reached - reduced(row, column);
            }
        }
        for (const Index column : settled) price_[column] += distance[column] - reached;
        for (Index column = end; column >= 0;) {
            const Index to = previous_row[static_cast<std::size_t>(column)];
            const Index next = column_of(to);
            assign(to, column);
            column = to == start ? -1 : next;
        }
    }

    const Matrix& cost_;
    Index n_rows_, n_columns_;
    Vector price_;
    std::vector<Index> column_of_, row_of_;
};

void require_finite(const Matrix& cost) {
    constexpr double largest = 1e200;  // sums of a few costs along a path stay finite
    for (Eigen::Index i = 0; i < cost.rows(); ++i) {
        for (Eigen::Index j = 0; j < cost.cols(); ++j) {
            if (!(std::abs(cost(i, j)) <= largest))
                throw InvalidInput(
                    fmt::format("solve_assignment: the cost of row {} and column {} is {}; it must be finite",
                                i, j, cost(i, j)));
        }
    }
}

}  // namespace

std::vector<Index> solve_assignment(const Matrix& cost, const Progress& progress) {
    require_finite(cost);
    std::vector<Index> column_of_row(static_cast<std::size_t>(cost.rows()), -1);
    if (cost.size() == 0) return column_of_row;
    if (cost.rows() <= cost.cols()) return Assignment(cost).solve(progress);
    const Matrix transposed = cost.transpose();
    const std::vector<Index> row_of_column = Assignment(transposed).solve(progress);
    for (std::size_t column = 0; column < row_of_column.size(); ++column)
        column_of_row[static_cast<std::size_t>(row_of_column[column])] = static_cast<Index>(column);
    return column_of_row;
}

}  // namespace counterpart::numerics
