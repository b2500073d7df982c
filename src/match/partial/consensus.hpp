// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/surface.hpp"

#include <cstdint>
#include <vector>

namespace counterpart::partial_match {

/// An image, as the number of a target sample, for each source sample, and how far each is trusted.
struct SampleMap {
    std::vector<Index> image;
    std::vector<float> vote;     // in [0, 1]
    std::vector<float> support;  // share of the other samples' votes that agree, in [0, 1]
    double total = 0;            // the larger, the better
};

/// What the steps below work from. The first `n_landmarks` samples of both surfaces are known to correspond
/// in turn.
struct SamplePair {
    const Surface& source;
    const Surface& target;
    Index n_landmarks = 0;
    MatrixF similarity;  // mean of the SHOT similarities over all radii: source samples x target samples

    SamplePair(const Surface& a, const Surface& b, Index n_landmarks, const SurfaceTuning& tuning);
};

/// Step 2. Each source sample may go to the target samples that look most like it. Matches whose distances
/// agree support each other (spectral matching: Leordeanu and Hebert 2005), and groups of them are gathered
/// from many seeds: right maps, mirrored ones, the same part fitted elsewhere. Best first.
std::vector<SampleMap> consensus_maps(const SamplePair& pair, const ConsensusTuning& tuning,
                                      std::uint64_t seed, const ProgressRange& progress = {});

/// Step 3. Images chosen anew among all target samples, from the votes of all source samples at once, until
/// few change (iterated conditional modes: Besag 1986).
SampleMap relabel(const SamplePair& pair, const SampleMap& start, const ConsensusTuning& consensus,
                  const RelabelingTuning& tuning);

/// More than `share` of the images are equal.
bool are_same(const SampleMap& a, const SampleMap& b, double share);

}  // namespace counterpart::partial_match
