// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/island_pairing.hpp"

#include <counterpart/match/exact.hpp>

namespace counterpart {

/// pair_islands for islands that share vertices: patches of a mesh cut open along what is not manifold.
/// Backtracks until what they share agrees. The ways that are found first, at most 1000 or as many as can be
/// measured in about a second, are measured; returns the best first, at most `most` (1 or more). None if
/// nothing fits; throws NumericalError if the search is cut short before it finds any.
std::vector<Pairing> pair_linked_islands(const MatchedMaps& maps, bool turned, std::size_t most);

/// Automorphisms of the source as a whole, counted one by one up to 1000.
Count count_linked_automorphisms(const MatchedMaps& maps, bool turned);

}  // namespace counterpart
