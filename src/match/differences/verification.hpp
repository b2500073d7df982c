// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/differences/growth.hpp"
#include "match/differences/prediction.hpp"

namespace counterpart::differences {

/// The map without what chance explains and without what lies in the wrong place.
///
/// What is left of a map.
struct Verified {
    std::vector<Index> image;
    /// In [0, 1]: how far below what chance gives the deviation of lengths is, over all that is left.
    double agreement = 0;
};

/// Matched triangles fall into regions that hang together over edges. The largest first, a region is kept if
/// it lies where the regions kept before, near it, expect it; where there are none, if it tells where it
/// belongs: if what its irregular vertices say, -log2 of the frequency of each valence but the commonest, and
/// what its lengths say, exceeds by DifferenceTuning::significance bits what it takes to choose one of all
/// placements. Lengths have a veto: a region where they deviate as much as where a mesh lies on itself by
/// chance says nothing, however large it is. Unless all that is kept says enough, nothing is. Then single
/// vertices at differences go whose neighbors expect them elsewhere.
///
/// `partner`: the target triangle of each source triangle or -1; triangles in `known` are not judged one by
/// one. O(F).
Verified verified(const PairSide& source, const PairSide& target, const std::vector<Index>& map,
                  const std::vector<Index>& partner, const std::vector<bool>& known, Prediction& prediction);

}  // namespace counterpart::differences
