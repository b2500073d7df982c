// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/consensus.hpp"
#include "match/partial/one_way_fit.hpp"
#include "match/partial/overlap.hpp"

#include <counterpart/base/progress.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::partial_match {

/// One way in which the part fits.
struct Fit {
    SampleMap anchors;         // of the part's samples
    BentSource bent;           // of all the part's vertices
    std::vector<float> alike;  // of each sample, the SHOT similarity with its image
    double score = 0;          // their mean
    double agreement = 0;      // mean support of the anchors
    double total = 0;          // the larger, the better; comparable within a pair
};

/// Steps 2 to 6: the ways in which the part fits the whole, best first. `pins` are vertices that are images
/// of each other in all of them.
std::vector<Fit> fits(const SamplePair& pair, const std::vector<std::pair<Index, Index>>& pins,
                      const PartialTuning& tuning, std::uint64_t seed, Stopwatch& watch,
                      const ProgressRange& progress);

/// The chosen way in its final shape.
struct Finished {
    PartnerMaps maps;
    double misfit =
        0;  ///< before it was finished (see PartnerMaps): a pliable surface hides what does not fit
};

/// Step 8. What has a partner pulls on, ever more pliable; then partners are looked for once more.
Finished finish(const SamplePair& pair, BentSource bent, bool part_is_covered, const PartialTuning& tuning,
                const ProgressRange& progress);

/// The factor by which the part must grow so that its lengths are those of the whole. Tried from `least` to
/// `most`.
double find_scale(const Surface& part, const Surface& whole, Index n_landmarks, double least, double most,
                  const PartialTuning& tuning, std::uint64_t seed, const ProgressRange& progress);

}  // namespace counterpart::partial_match
