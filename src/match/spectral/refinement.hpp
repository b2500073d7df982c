// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Weights are relative to the spectral coordinates, at unit area.
struct RefineOptions {
    int last = 200;                  ///< eigenfunctions of the last steps
    float feature_weight = 5;        ///< of curvature and wave kernel, each of variance 1
    float position_weight = 200;     ///< of positions after an elastic fit of A to its images
    float normal_weight = 20;        ///< of the normals there
    double stiffness_length = 0.08;  ///< the fit keeps shapes below this size
    int iterations = 8;              ///< of the elastic fit in a round
    int rounds = 6;
    int rounds_if_huge = 2;  ///< above three times `large_mesh` vertices
};

/// The map of a candidate from `choose` carried to all vertices of both shapes.
PairedMaps refine(const Shape& a, const Shape& b, const Candidate& start, const RefineOptions& options = {});

/// Candidates refined on more and in the end on all samples and sorted again, best first; at most `count`.
std::vector<Candidate> choose(const Shape& a, const Shape& b, std::vector<Candidate> candidates,
                              std::size_t count);

}  // namespace counterpart::spectral_match
