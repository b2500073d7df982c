// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 5, with the choice that only full refinement allows. Of the finalists (best first, as choose_best
/// leaves them) the best and those that score nearly as well are refined in full. The one that is then best
/// by relief, by the way there and back, and by what is known of the map comes first and keeps its score; the
/// others score less by as much as they are worse. Unless the winner is a near isometry, it is refined again
/// from its own result, for as long as that gains. `maps` and `on_vertices` are those refined; rivals that
/// have become the same map are dropped.
void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
