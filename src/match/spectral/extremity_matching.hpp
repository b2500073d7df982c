// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Which extremity of A is which of B: partial matchings that keep geodesic distances.
#pragma once

#include "match/spectral/shape.hpp"

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

struct ExtremityMatching {
    std::vector<std::pair<int, int>> pairs;  // extremity of A, extremity of B
    double cost = 0;
};

/// At most `count` matchings by increasing cost, any two of which mean different maps.
std::vector<ExtremityMatching> match_extremities(const Shape& a, const Shape& b, std::size_t count);

}  // namespace counterpart::spectral_match
