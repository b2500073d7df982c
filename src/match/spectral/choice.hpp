// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Candidates refined on more and in the end on all samples and sorted again, best first; at most `count`.
std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count);

}  // namespace counterpart::spectral_match
