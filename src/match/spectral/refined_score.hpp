// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

/// Equation 7, which tells refined maps of unlike shapes apart: relief, normals of neighborhoods that are
/// turned as the map turns them, the way there and back, tears, and what a person has said. Between all
/// vertices.
double refined_score(const SampledPair& all, const PairedMaps& maps, const RefinedScoreTuning& tuning);

}  // namespace counterpart::spectral_match
