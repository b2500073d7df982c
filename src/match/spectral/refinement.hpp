// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 5. The map of a candidate from `select`, between all samples, carried to all vertices of both
/// shapes; one that has been refined before goes on from there (`on_vertices`), unless `tuning` says
/// otherwise. Exchanging the shapes exchanges the maps. Pinned landmarks hold exactly, and the surfaces are
/// bent through them.
PairedMaps refine(const SampledPair& all, const Candidate& start, const RefinementTuning& tuning = {},
                  const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
