// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/sampled_pair.hpp"

#include <vector>

namespace counterpart::spectral_match {

/// By what proposals are ranked before they are refined. What tells a right map from a mirrored, half-turned
/// or twisted one; no term alone is enough. The pair must outlive it.
class Promise {
  public:
    Promise(const SampledPair& pair, const PromiseTuning& tuning);

    /// The larger, the better: the correlation of smoothed mean curvature under the map, how well orientation
    /// is kept, less how far the functional maps are from orthogonal (as isometries' are), what the best
    /// rotations leave of neighborhoods (0: locally rigid, 1: not), and what contradicts priors. Exchanging
    /// the shapes changes nothing. -infinity where it is not a number.
    double operator()(const PairedMaps& maps, const PairedFunctionalMaps& functional) const;

  private:
    const SampledPair& pair_;
    const PromiseTuning tuning_;
    MatrixF positions_a_, positions_b_;
    std::vector<std::vector<Index>> near_a_, near_b_;
};

}  // namespace counterpart::spectral_match
