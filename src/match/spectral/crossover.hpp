// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Maps that follow `base` except on the limbs that `other` exchanges, turns or flips, one group of limbs at
/// a time: what is right about the one and what is right about the other together. Between the samples of
/// `pair`, which all maps must be between; not grown and without scores.
std::vector<Candidate> crossovers(const SampledPair& pair, const Candidate& base, const Candidate& other);

}  // namespace counterpart::spectral_match
