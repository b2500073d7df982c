// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

struct RefineOptions {
    float feature_weight = 3;
    float position_weight = 0, normal_weight = 0;
    int rounds = 3;
    int last = 200;
};

/// The candidate's map carried to all vertices of both shapes.
PairedMaps refine(const Shape& a, const Shape& b, const PairedFunctionalMaps& start,
                  const RefineOptions& options = {});

/// Candidates refined on more samples and sorted again, best first; at most `count`.
std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count);

}  // namespace counterpart::spectral_match
