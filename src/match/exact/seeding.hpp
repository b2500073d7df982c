// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Where the matching of two meshes that differ in places can begin.
#pragma once

#include "match/exact/walk.hpp"

#include <utility>
#include <vector>

namespace counterpart {

/// A flag of the source and its image.
using FlagPair = std::pair<Flag, Flag>;

/// Vertex colours that see 2, 4, 8, 16 and 32 edges far. O(32 F).
struct SeedColors {
    SeedColors(const CombinatorialMap& a, const CombinatorialMap& b);
    std::vector<std::vector<Color>> source, target;
};

/// What is left to match of one side.
struct OpenPart {
    const CombinatorialMap& map;
    const std::vector<Color>& colors;
    const std::vector<bool>& done;  ///< triangles
};

struct Seeds {
    std::vector<FlagPair> unique;  ///< their colour occurs once on either side
    std::vector<FlagPair> rare;    ///< all ways for the colours with the fewest, up to 2000
};
/// `parity`: 1 if the surfaces are wound against each other. O(F log F).
Seeds find_seeds(const OpenPart& source, const OpenPart& target, unsigned parity);

/// Some forty triangles around a seed, if they agree far beyond chance: the walk closes around vertices as it
/// must. Else none.
std::vector<FlagPair> surroundings(const CombinatorialMap& a, const CombinatorialMap& b, FlagPair seed);

}  // namespace counterpart
