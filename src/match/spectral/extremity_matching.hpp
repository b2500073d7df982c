// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Stage 2a. Which extremity of A is which of B: partial matchings that keep geodesic distances.
#pragma once

#include "match/spectral/sampled_pair.hpp"

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

using ExtremityPairs = std::vector<std::pair<int, int>>;  // of A and B

struct ExtremityMatching {
    ExtremityPairs pairs;
    double cost = 0;
};

/// Of the prominent extremities, then of all; both by increasing cost, any two of which mean different maps.
std::vector<ExtremityMatching> match_extremities(const SampledPair& pair, const ExtremityTuning& tuning);

}  // namespace counterpart::spectral_match
