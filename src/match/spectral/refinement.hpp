// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/candidates.hpp"

namespace counterpart::spectral_match {

/// Weights are relative to the spectral coordinates, lengths at unit area. The rounds go from few functions
/// and stiff surfaces to many functions and pliable ones.
struct RefineOptions {
    int begin = 80;               ///< eigenfunctions of the maps that the first round starts from
    int first = 30, last = 200;   ///< eigenfunctions of the first and last round
    float feature_weight = 5;     ///< of curvature and wave kernel, each of variance 1
    float position_weight = 200;  ///< of positions after an elastic fit of either surface to its images
    float normal_weight = 14;     ///< of the normals there
    double first_length = 0.3, last_length = 0.06;  ///< the fits keep shapes below this size
    int iterations = 16;                            ///< of an elastic fit
    int rounds = 8;
    int rounds_if_huge = 2;  ///< above three times `large_mesh` vertices
};

struct Refined {
    PairedMaps maps;
    double strain = 0;  ///< mean of the two surfaces' as they were bent last (see ElasticFit)
};

/// The map of a candidate from `choose` carried to all vertices of both shapes. Exchanging the shapes
/// exchanges the maps.
Refined refine(const Shape& a, const Shape& b, const Candidate& start, const RefineOptions& options = {});

}  // namespace counterpart::spectral_match
