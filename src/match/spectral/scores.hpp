// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What tells a right map from a mirrored, half-turned or twisted one. No one score is enough.
#pragma once

#include "match/spectral/shape.hpp"

namespace counterpart::spectral_match {

/// Both shapes on their first n samples.
struct SampledPair {
    const Shape& a;
    const Shape& b;
    SpectralPoints points_a, points_b;

    SampledPair(const Shape& shape_a, const Shape& shape_b, std::size_t n)
        : a(shape_a), b(shape_b), points_a(sampled(shape_a, n)), points_b(sampled(shape_b, n)) {}
};

/// How well a map keeps what a right map keeps.
struct Scores {
    double curvature = 0;      // correlation of the ranks of smoothed mean curvature under the map
    double orientation = 0;    // +1 preserved, -1 reflected
    double orthogonality = 0;  // |C^T C - I|^2 / k: 0 for an isometry
    double rigidity =
        0;  // residual of neighbourhoods of samples after the best rotation: 0 = locally rigid, 1 = not
    double total = 0;  // the larger, the better
};

/// Scores of maps between the first samples of either side and the functional maps fitted to them. Curvature
/// is read at scale `curvature_scale` (0 = finest .. 3); neighbourhoods have geodesic radius `radius`.
Scores score_maps(const SampledPair& pair, const PairedMaps& maps, const PairedFunctionalMaps& functional,
                  int curvature_scale, double radius);

}  // namespace counterpart::spectral_match
