// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 5, with the choice that only full refinement allows. Refines the best of the finalists (best first,
/// as choose_best leaves them) and those that score nearly as well; each map replaces `on_vertices`. The one
/// that is then best by relief, and by how well the map there and back returns without tears, comes first;
/// what it passes scores no more than it.
void refine_rivals(std::vector<Candidate>& finalists, const SampledPair& all, const RivalTuning& tuning,
                   const RefinementTuning& refinement, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
