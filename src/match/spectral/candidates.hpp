// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

/// Stages 2.1 to 2.3. Starts from extremities and landmarks and from similar poses, grown by ZoomOut; best
/// first, all different.
std::vector<Candidate> start_candidates(const SampledPair& pair, const CandidateTuning& tuning,
                                        const ProgressRange& progress = {});

/// Stage 2.4. Those, varied by sign flips and started anew from their own tips; best first, all different.
/// Takes four times as long as starting.
std::vector<Candidate> vary_candidates(const SampledPair& pair, std::vector<Candidate> started,
                                       const CandidateTuning& tuning, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
