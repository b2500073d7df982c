// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 3. The candidates found on `coarse`, grown on more and in the end on all samples, the best crossed
/// with the others; best first, at most `count` and at most as many as differ.
std::vector<Candidate> select(const SampledPair& coarse, std::vector<Candidate> candidates, std::size_t count,
                              const SelectionTuning& tuning, const ProgressRange& progress = {});

/// The same without crossing, if the best map is then right beyond doubt: nearly an isometry, and none of the
/// others comes near its score. Else none.
std::vector<Candidate> select_if_decided(const SampledPair& coarse, std::vector<Candidate> candidates,
                                         std::size_t count, const SelectionTuning& tuning,
                                         const ProgressRange& progress = {});

/// Maps that follow `base` except on the limbs that `other` exchanges, turns or flips, one group of limbs at
/// a time: what is right about the one and what is right about the other together. Between the samples of
/// `pair`, which all maps must be between; not grown and without scores.
std::vector<Candidate> crossovers(const SampledPair& pair, const Candidate& base, const Candidate& other,
                                  const SelectionTuning& tuning);

}  // namespace counterpart::spectral_match
