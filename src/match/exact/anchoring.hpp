// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Where every island is symmetric or has equals, nothing says where to begin: some begin is assumed.
#pragma once

#include "match/exact/symmetry_choice.hpp"

namespace counterpart {

/// Motions worth a try, best first, at most `most`: those that take one island of the class with the fewest
/// choices onto each of its partners by each automorphism that keeps its edge lengths, ranked by how close
/// they bring the centres of the other islands to centres of their kind. None if one island is all there is,
/// or the choices are too many to be tried; `turned` as in pair_islands.
std::vector<Motion> starting_motions(const MatchedMaps& maps, const PairGeometry& geometry, bool turned,
                                     std::size_t most);

}  // namespace counterpart
