// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/extremity_matching.hpp"

namespace counterpart::spectral_match {

/// Pairs of prominent extremities that the maps of vertices take to within `most` of each other, there and
/// back: the nearest first, each extremity once.
ExtremityPairs matched_extremities(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps,
                                   double most);

/// Matchings of prominent extremities one exchange away from this one: two pairs exchange partners, an
/// extremity without one takes that of another, or two without become a pair. The `most` that change
/// distances between extremities least, least first; of a single pair, the average distance from the surface.
/// O(n^4 log n) for n extremities, at most 12.
std::vector<ExtremityPairs> exchanges(const PreparedShape& a, const PreparedShape& b,
                                      const ExtremityPairs& matching, std::size_t most);

}  // namespace counterpart::spectral_match
