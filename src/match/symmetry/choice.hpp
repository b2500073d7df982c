// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Connectivity often leaves a choice: which of several equal components is which, and which way round a
// symmetric one lies. The isomorphism of least error is chosen.
#pragma once

#include "match/symmetry/pair_geometry.hpp"

#include <counterpart/base/progress.hpp>

namespace counterpart::symmetry {

struct Choice {
    std::vector<ComponentPair> pairs;
    Fit fit;
    Alignment alignment;
};

/// Fills in fit and alignment of the chosen pairs.
void measure(const MatchedMaps& maps, const PairGeometry& geometry, bool reversed, Choice& choice);

/// True if connectivity leaves geometry nothing to choose.
bool is_determined(const MatchedMaps& maps);

/// Pairs as many components as there are partners for, so that the orientation is kept, or `reversed`;
/// components for which that is impossible are paired against the rule at the end.
///
/// The alignment is known from components that leave no choice, or else found by trying: as the meshes lie,
/// principal axes onto principal axes, and one component onto each of its possible images. Equal components
/// are then assigned by place, size and direction (an optimal assignment), a symmetric one takes its best
/// automorphism, and the alignment is fitted again to the result.
Choice choose_isomorphism(const MatchedMaps& maps, bool reversed, const Progress& progress = {});

/// Isomorphisms that differ from the choice in the automorphism of one component or in an exchange of two,
/// best first, at most `max`.
std::vector<Choice> other_choices(const MatchedMaps& maps, const Choice& choice, bool reversed,
                                  std::size_t max);

/// The pairs of the choice, by number, that place alone decides: another automorphism, or another component
/// of the class, keeps the lengths of edges about as well. O(what choosing took).
std::vector<std::size_t> decided_by_place(const MatchedMaps& maps, const Choice& choice, bool reversed);

}  // namespace counterpart::symmetry
