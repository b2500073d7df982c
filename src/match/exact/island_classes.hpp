// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Which islands of two maps are the same but for numbering, and in how many ways.
#pragma once

#include "match/exact/automorphisms.hpp"
#include "match/exact/walk.hpp"

#include <vector>

namespace counterpart {

/// An island and how the class's representative lies on it.
struct Member {
    Index island = 0;
    Images from_representative;  ///< of the representative's triangles
    unsigned parity = 0;         ///< 1 if that turns the winding over
};

/// Isomorphic islands; mirrored ones are in one class and differ in parity.
struct IslandClass {
    bool in_target =
        false;  ///< the representative is an island of the target (the source has none of the class)
    Index island = 0;
    Flag root = 0;  ///< of the rarest colour on the representative
    std::vector<Member> source, target;
};

struct Classification {
    std::vector<IslandClass> classes;
    std::vector<Color> source_colors, target_colors;
};

/// Every island of both maps in exactly one class. Linear for islands whose rarest colour is rare; colours
/// are refined further where too many walks fail.
Classification classify_islands(const CombinatorialMap& source, const CombinatorialMap& target);

}  // namespace counterpart
