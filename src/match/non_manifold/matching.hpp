// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/symmetry/choice.hpp"

#include <counterpart/match/exact.hpp>

namespace counterpart::non_manifold {

/// choose_isomorphism for components that share vertices: patches of a mesh cut open along what is not
/// manifold. A backtracking search places patch after patch so that what they share agrees; the isomorphisms
/// that it finds first, at most ExactTuning::max_isomorphisms, are compared. Returns the best first, at most
/// `max` (1 or more); none if nothing fits. Throws NumericalError if the search is cut short before it finds
/// any.
std::vector<symmetry::Choice> match_patches(const symmetry::MatchedMaps& maps, bool reversed, std::size_t max,
                                            const Progress& progress = {});

/// Automorphisms of the source as a whole, counted one by one up to ExactTuning::max_isomorphisms.
Count count_automorphisms(const symmetry::MatchedMaps& maps, bool reversed);

}  // namespace counterpart::non_manifold
