// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

namespace counterpart::spectral_match {

struct Refined {
    PairedMaps maps;
    double strain = 0;  ///< mean of the two surfaces' as they were bent last (see ElasticFit)
};

/// Stage 5. The map of a candidate from `select` carried to all vertices of both shapes. Exchanging the
/// shapes exchanges the maps.
Refined refine(const PreparedShape& a, const PreparedShape& b, const Candidate& start,
               const RefinementTuning& tuning = {}, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
