// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Where the matching of two meshes that differ in places can begin.
#pragma once

#include "match/isomorphism/traversal.hpp"

#include <utility>
#include <vector>

namespace counterpart::differences {

using isomorphism::Color;
using isomorphism::Dart;
using isomorphism::DartMap;
/// A dart of the source and its image.
using DartPair = std::pair<Dart, Dart>;

/// What is left to match of one mesh.
struct OpenPart {
    const DartMap& map;
    const std::vector<Color>& colors;
    const std::vector<bool>& done;  ///< triangles
};

/// Pairs of open darts whose color occurs once on either side; or, if `shared`, all pairs for the colors with
/// the fewest, up to DifferenceTuning::max_rare. `parity`: 1 if the surfaces are wound against each other. Of
/// more than `max_darts` open ones, some are looked at, picked by color. O(F log F).
std::vector<DartPair> find_seeds(const OpenPart& source, const OpenPart& target, unsigned parity, bool shared,
                                 std::size_t max_darts);

/// Some forty triangles around a seed, if they agree far beyond chance: the traversal closes around vertices
/// as it must. Else none.
std::vector<DartPair> surroundings(const DartMap& a, const DartMap& b, DartPair seed);

}  // namespace counterpart::differences
