// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace counterpart::numerics {

/// Of an even number of values the upper one of both in the middle; 0 of none. O(n).
double median(std::vector<double> values);
float median(std::vector<float> values);

/// The median of how far values are from their median; 0 of none. O(n).
double median_absolute_deviation(std::vector<double> values);

}  // namespace counterpart::numerics
