// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/level.hpp"

#include <vector>

namespace counterpart::spectral_match {

/// What a map takes elsewhere than its surroundings.
struct Islands {
    std::vector<char> inside;   ///< per vertex: 1 in a patch that is torn off all around
    std::vector<char> spoiled;  ///< per vertex: 1 there and at the near side of the tears
    bool empty = true;
};

/// Patches of A of at most `max_share` of its area that a map separates from all that they are connected to
/// on A: every edge out of them is torn, that is its ends go farther apart by `gap`, or by `jump` along the
/// surface, than the edges around it suggest (by their median factor: a limb that goes to a longer one
/// stretches all along). Two ears that are exchanged are such patches; each fits where it is, and so nothing
/// near it looks wrong. O(V).
Islands find_islands(const LevelShape& from, const LevelShape& to, const std::vector<Index>& b_from_a,
                     const IslandTuning& tuning);

}  // namespace counterpart::spectral_match
