// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/isomorphism/traversal.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace counterpart::isomorphism {

/// Darts of one color, by parity. On a one-sided component both directions count as parity 0.
using DartsByParity = std::array<std::vector<Dart>, 2>;

/// Darts of the component that may be images of `root`, a dart of `root_map`: those of the same color.
/// O(size).
DartsByParity darts_like(const DartMap& root_map, const std::vector<Color>& root_colors, Dart root,
                         const DartMap& map, const std::vector<Color>& colors, Index component);

/// The symmetries of one component's connectivity. An automorphism is fixed by where it takes the root, so
/// the orientation-preserving ones are as many as the darts in the root's orbit, and a few generators tell
/// the orbit without a traversal for each dart in it.
struct AutomorphismGroup {
    std::vector<Images> generators;
    std::vector<Dart> orbit;  ///< images of the root under the orientation-preserving ones; [0] = root
    std::vector<std::uint32_t> parent;  ///< orbit[i] = generators[generator[i]] (orbit[parent[i]])
    std::vector<std::uint32_t> generator;
    Images mirror;  ///< one orientation-reversing automorphism; empty if there is none

    std::size_t order() const { return orbit.size(); }
};

/// O(size * (log order + failing traversals)); a traversal that fails rules out a whole coset.
AutomorphismGroup find_automorphisms(const DartMap& map, const std::vector<Color>& colors, Index component,
                                     Dart root);

}  // namespace counterpart::isomorphism
