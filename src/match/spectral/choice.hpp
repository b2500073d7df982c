// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Candidates grown on more and in the end on all samples, best first, at most `count`, any two of which
/// differ by more than 0.05 on average. The best are crossed with each other before, and those whose scores
/// are too close to tell are tried out on the surfaces; what that costs the worse one is taken off its score.
std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count);

}  // namespace counterpart::spectral_match
