// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 5, with the choice that only full refinement allows. Of the finalists (best first) the best and
/// those that score nearly as well are refined in full; of those the best by equation 7 are refined again
/// from their own results, fewer each round, for as long as that gains, if the tuning asks for it, and the
/// winner finally with both maps pulling. The one that is then best comes first and keeps its score; the
/// others score less by as much as they are worse. `maps` and `on_vertices` are those refined; rivals that
/// have become the same map are dropped.
void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
