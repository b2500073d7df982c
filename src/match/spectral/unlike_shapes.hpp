// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <optional>
#include <vector>

namespace counterpart::spectral_match {

/// Stage 4 of unlike shapes, instead of stage 3 as well. Which of their maps is right shows only once they
/// are refined, and many need it: all but the last refinement are on coarse copies of both shapes. First
/// briefly (choose_unlike), then rivals in full and again (refine_rivals), and the winner with other
/// matchings of extremities (rematch_extremities). At least `count` maps, best first, if there are as many;
/// `on_vertices` are of the shapes themselves.
///
/// `unguided`, where there are pinned landmarks, is the map that is found without them. The best is then
/// taken of the winner, the winner refined with nothing but the pins to follow, and `unguided` refined so.
std::vector<Candidate> search_unlike(std::vector<Candidate> candidates,
                                     const std::optional<Candidate>& unguided, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress = {});

/// As the winner is to be refined from then on if rematching gained.
RefinementTuning winners_refinement(const SpectralTuning& tuning);

}  // namespace counterpart::spectral_match
