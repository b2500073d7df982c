// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Stage 6: how far a map deserves trust, and how the runners-up differ.
#pragma once

#include "match/spectral/polish.hpp"

#include <string>

namespace counterpart::spectral_match {

/// Per vertex of A in [0, 1]: near 1 where the map there and back returns and keeps neighbors together,
/// where runners-up that score nearly as well agree, and if the map scores well. Low in islands, wherever
/// these are.
Vector confidence(const Level& whole, const Polished& found);

/// How a runner-up differs from the best map.
struct Departure {
    std::string words;
    double moved = 0;  ///< share of the surface that it takes elsewhere; all where it is mirrored
};
Departure departure(const Level& whole, const Map& best, const Map& other);

}  // namespace counterpart::spectral_match
