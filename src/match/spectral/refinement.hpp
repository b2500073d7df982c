// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Stage 5. The map of a candidate from `select` carried to all vertices of both shapes. Exchanging the
/// shapes exchanges the maps. `pins` hold exactly, and the surfaces are bent through them.
PairedMaps refine(const PreparedShape& a, const PreparedShape& b, const Candidate& start,
                  const VertexPairs& pins = {}, const RefinementTuning& tuning = {},
                  const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
