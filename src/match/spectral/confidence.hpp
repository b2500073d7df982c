// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Stage 6: how far a map deserves trust, and how the runners-up differ.
#pragma once

#include "match/spectral/candidate.hpp"

#include <string>

namespace counterpart::spectral_match {

/// Per vertex of A in [0, 1]: near 1 where the map there and back returns and keeps neighbors together,
/// where `candidates` (best first, the one refined) that score nearly as well agree, and if the best scores
/// well. Low in islands, wherever these are.
Vector confidence(const SampledPair& pair, const PairedMaps& maps, const std::vector<Candidate>& candidates,
                  const ConfidenceTuning& tuning = {});

/// How `other` differs from `best`, in words.
std::string describe(const SampledPair& pair, const Candidate& best, const Candidate& other,
                     const ConfidenceTuning& tuning = {});

}  // namespace counterpart::spectral_match
