// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 4. Where the scores of finalists (best first, between all samples) are too close to tell and the
/// maps differ in a limb, each is refined briefly: the wrong map strains the surfaces more, and loses score
/// by it. A half-turned body is hardly strained, so maps that differ as a whole are left to their scores.
void run_trials(std::vector<Candidate>& finalists, const SampledPair& all, const TrialTuning& tuning,
                const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
