// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidate.hpp"

#include <string>
#include <vector>

namespace counterpart::spectral_match {

/// Sentences about what makes the match of these two shapes doubtful: defects of the inputs, symmetric
/// shapes, a poor score, a close runner-up. `finalists` between all samples, best first.
std::vector<std::string> warnings(const SampledPair& pair, const std::vector<Candidate>& finalists,
                                  const ConfidenceTuning& tuning = {});

}  // namespace counterpart::spectral_match
