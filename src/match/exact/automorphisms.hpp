// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/walk.hpp"

#include <cstdint>
#include <vector>

namespace counterpart {

/// Flags of the island that may be images of `root`, a flag of `root_map`: of the same colour and the given
/// parity. On a one-sided island both directions count as parity 0.
std::vector<Flag> flags_like(const CombinatorialMap& root_map, const std::vector<Color>& root_colors,
                             Flag root, const CombinatorialMap& map, const std::vector<Color>& colors,
                             Index island, unsigned parity);

/// The symmetries of one island's connectivity. An automorphism is fixed by where it takes the root, so the
/// orientation-preserving ones are as many as the flags in the root's orbit, and a few generators tell the
/// orbit without a walk for each flag in it.
struct AutomorphismGroup {
    std::vector<Images> generators;
    std::vector<Flag> orbit;  ///< images of the root under the orientation-preserving ones; [0] = root
    std::vector<std::uint32_t> parent;  ///< orbit[i] = generators[generator[i]] (orbit[parent[i]])
    std::vector<std::uint32_t> generator;
    Images mirror;         ///< one orientation-reversing automorphism; empty if there is none
    bool complete = true;  ///< false: the search was cut short and there may be more

    std::size_t order() const { return orbit.size(); }
};

/// O(size * (log order + failing walks)); a walk that fails rules out a whole coset.
AutomorphismGroup find_automorphisms(const CombinatorialMap& map, const std::vector<Color>& colors,
                                     Index island, Flag root);

}  // namespace counterpart
