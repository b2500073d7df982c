// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/rank_correlation.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

namespace counterpart::numerics {
namespace {

// The rank of each number; the mean of all is 0.
Vector ranks(const Vector& numbers) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(numbers.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](Eigen::Index i, Eigen::Index j) { return numbers[i] < numbers[j]; });
    Vector result(numbers.size());
    const double middle = (static_cast<double>(numbers.size()) - 1) / 2;
    for (std::size_t i = 0; i < order.size(); ++i) result[order[i]] = static_cast<double>(i) - middle;
    return result;
}

}  // namespace

double rank_correlation(const Vector& first, const Vector& second) {
    if (first.size() < 2) return 0;
    const Vector a = ranks(first), b = ranks(second);
    return a.dot(b) / (a.norm() * b.norm());
}

}  // namespace counterpart::numerics
