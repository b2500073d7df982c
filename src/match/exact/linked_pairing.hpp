// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/island_pairing.hpp"

#include <counterpart/match/exact.hpp>

namespace counterpart {

/// pair_islands for islands that share vertices: patches of a mesh cut open along what is not manifold.
/// Backtracks until what they share agrees; among what fits, geometry goes first. No pairs if nothing fits;
/// throws NumericalError if the search is cut short.
Pairing pair_linked_islands(const MatchedMaps& maps, bool turned);

/// Automorphisms of the source as a whole, counted one by one up to 1000.
Count count_linked_automorphisms(const MatchedMaps& maps, bool turned);

}  // namespace counterpart
