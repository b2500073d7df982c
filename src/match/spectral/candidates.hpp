// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

/// Stage 2. Starts from extremities and landmarks and from similar poses, grown by ZoomOut and varied by sign
/// flips; best first, all different.
std::vector<Candidate> find_candidates(const SampledPair& pair, const CandidateTuning& tuning,
                                       const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
