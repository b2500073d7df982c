// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/median.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::numerics {
namespace {

template <class T>
T upper_middle(std::vector<T> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

double median(std::vector<double> values) { return upper_middle(std::move(values)); }

float median(std::vector<float> values) { return upper_middle(std::move(values)); }

double median_absolute_deviation(std::vector<double> values) {
    const double middle = median(values);
    for (double& value : values) value = std::abs(value - middle);
    return median(std::move(values));
}

}  // namespace counterpart::numerics
