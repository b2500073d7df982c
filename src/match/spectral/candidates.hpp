// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

/// Stages 2.1 to 2.3. Starts from extremities and landmarks and from similar poses, grown by ZoomOut; best
/// first, all different. Exchanging the shapes exchanges the maps.
std::vector<Candidate> start_candidates(const SampledPair& pair, const CandidateTuning& tuning,
                                        const ProgressRange& progress = {});

/// Of these only the starts from the `count` matchings of prominent extremities that keep distances best,
/// with the orientation kept: at little cost.
std::vector<Candidate> few_candidates(const SampledPair& pair, std::size_t count,
                                      const CandidateTuning& tuning);

/// Stage 2.4. Those, the first of them varied by sign flips, and the best started anew from their own tips;
/// best first, all different.
std::vector<Candidate> vary_candidates(const SampledPair& pair, std::vector<Candidate> started,
                                       const CandidateTuning& tuning, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
