// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/symmetry/pair_geometry.hpp"

namespace counterpart::symmetry {

/// Alignments worth a try where every component is symmetric or has equals, best first: principal axes onto
/// principal axes; and, where these are at most ExactTuning::max_initial, one component onto each partner by
/// each automorphism. Judged by how close they bring components to components of their class.
std::vector<Alignment> initial_alignments(const MatchedMaps& maps, const PairGeometry& geometry,
                                          isomorphism::SimultaneousTraversal& traversal, bool reversed);

}  // namespace counterpart::symmetry
