// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 4. The best finalists, between all samples, are refined briefly (`on_vertices`) and sorted by a
/// total score in which fine relief, similarity of neighborhoods and wringing count too: before they are
/// refined, a half-turned body fits as well as the right one. `all` has neighborhoods of CueTuning::radius.
void run_trials(std::vector<Candidate>& finalists, const SampledPair& all, const TrialTuning& tuning,
                const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
