// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 3. The candidates found on `coarse`, grown on more samples and, if the best one then is nearly an
/// isometry, on all; best first, at most `count` and at most as many as differ. Else none.
std::vector<Candidate> select(const SampledPair& coarse, std::vector<Candidate> candidates, std::size_t count,
                              const SelectionTuning& tuning, const ProgressRange& progress = {});

/// The same of the first few, if the best map is then right beyond doubt: none of the others comes near its
/// score. Else none.
std::vector<Candidate> select_if_decided(const SampledPair& coarse, std::vector<Candidate> candidates,
                                         std::size_t count, const SelectionTuning& tuning,
                                         const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
