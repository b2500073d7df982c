// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Steps 2 to 6 for two parts, which may overlap by little.
#pragma once

#include "match/partial/pipeline.hpp"
#include "match/partial/placements.hpp"

namespace counterpart::partial_match {

/// The ways in which two parts fit, best first: the placements and groups of samples, bent on copies of few
/// vertices; the better ones relabeled; those that gain most, on all vertices.
std::vector<Fit> fits_of_parts(const SamplePair& pair, const std::vector<Placement>& placements,
                               const std::vector<std::pair<Index, Index>>& pins, const PartialTuning& tuning,
                               std::uint64_t seed, Stopwatch& watch, const ProgressRange& progress);

/// The same as find_scale, of two parts: that of the best placement at any scale.
double scale_of_parts(const Surface& part, const Surface& whole, Index n_landmarks, double least, double most,
                      const PartialTuning& tuning);

}  // namespace counterpart::partial_match
