// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Weights are relative to the spectral coordinates, at unit area.
struct RefineOptions {
    int last = 200;                  ///< eigenfunctions of the last steps
    float feature_weight = 3;        ///< of curvature and wave kernel, each of variance 1
    float position_weight = 200;     ///< of positions after an elastic fit of A to its images
    float normal_weight = 10;        ///< of the normals there
    double stiffness_length = 0.15;  ///< the fit is rigid below this size
    int iterations = 4;              ///< of the elastic fit in a round
    int rounds = 4;
};

/// The candidate's map carried to all vertices of both shapes.
PairedMaps refine(const Shape& a, const Shape& b, const PairedFunctionalMaps& start,
                  const RefineOptions& options = {});

/// Candidates refined on more samples and sorted again, best first; at most `count`.
std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count);

}  // namespace counterpart::spectral_match
