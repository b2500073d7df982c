// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 4: which of the finalists, best first, is not half-turned and has each limb in its place. Those that
/// come close, between all samples, are refined briefly (`on_vertices`), the others only matched, and all are
/// sorted by a total score in which fine relief, similarity of neighborhoods and wringing count too
/// (half_turn_cues.hpp): before they are refined, a half-turned body fits as well as the right one. `all` has
/// neighborhoods of CueTuning::radius.
void choose_best(std::vector<Candidate>& finalists, const SampledPair& all, const FinalChoiceTuning& tuning,
                 const ProgressRange& progress = {});

/// Of unlike shapes, which have no stage 3: candidates (best first) are refined briefly as they are, and the
/// best distinct ones by equation 7 come first, at least `count` of them if there are as many. `scores` are
/// of the maps refined.
std::vector<Candidate> choose_unlike(std::vector<Candidate> candidates, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
