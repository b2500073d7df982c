// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Which components of two maps are the same but for numbering, and in how many ways.
#pragma once

#include "match/isomorphism/automorphisms.hpp"
#include "match/isomorphism/traversal.hpp"

#include <vector>

namespace counterpart::isomorphism {

/// A component and how the class's representative lies on it.
struct Member {
    Index component = 0;
    Images from_representative;  ///< of the representative's triangles
    unsigned parity = 0;         ///< 1 if that turns the winding over
};

/// Isomorphic components; mirrored ones are in one class and differ in parity.
struct ComponentClass {
    bool in_target =
        false;  ///< the representative is a component of the target (the source has none of the class)
    Index component = 0;
    Index first = 0;  ///< triangle of the representative, where its images begin
    Dart root = 0;    ///< of the rarest color on the representative
    std::vector<Member> source, target;
};

struct Classification {
    std::vector<ComponentClass> classes;
    std::vector<Color> source_colors, target_colors;
};

/// Every component of both maps in exactly one class. Linear for components whose rarest color is rare;
/// colors are refined further where too many traversals fail.
Classification classify_components(const DartMap& source, const DartMap& target);

}  // namespace counterpart::isomorphism
