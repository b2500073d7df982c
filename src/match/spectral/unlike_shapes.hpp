// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 4 of unlike shapes, instead of stage 3 as well. Which of their maps is right shows only once they
/// are refined, and many need it: all but the last refinement are on coarse copies of both shapes. First
/// briefly (choose_unlike), then rivals in full and again (refine_rivals). At least `count` maps, best first,
/// if there are as many; `on_vertices` are of the shapes themselves.
std::vector<Candidate> search_unlike(std::vector<Candidate> candidates, const SampledPair& all,
                                     std::size_t count, const SpectralTuning& tuning,
                                     const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
