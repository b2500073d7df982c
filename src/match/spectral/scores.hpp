// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What tells a right map from a mirrored, half-turned or twisted one. No one score is enough.
#pragma once

#include "match/spectral/shape.hpp"

namespace counterpart::spectral_match {

/// For each distance sample that is one of the first n samples: those of the n within a geodesic radius.
struct Neighborhoods {
    std::vector<std::size_t> first;  // where each one's begin; one more at the end
    std::vector<Index> samples;

    Neighborhoods(const Shape& shape, std::size_t n, double radius);
};

/// Both shapes on their first n samples, with neighbourhoods on which maps should be rigid.
struct SampledPair {
    const Shape& a;
    const Shape& b;
    SpectralPoints points_a, points_b;
    MatrixF positions_a, positions_b;
    Neighborhoods near_a, near_b;

    SampledPair(const Shape& shape_a, const Shape& shape_b, std::size_t n, double radius);
};

/// How well a map keeps what a right map keeps.
struct Scores {
    double curvature = 0;    // correlation of the ranks of smoothed mean curvature under the map
    double orientation = 0;  // +1 preserved, -1 reflected
    double rigidity =
        0;  // residual of neighbourhoods of samples after the best rotation: 0 = locally rigid, 1 = not
    double orthogonality = 0;  // |C^T C - I|^2 / k: 0 for an isometry
    double commutativity = 0;  // mean of C_ij^2 by relative gap of the eigenvalues i and j: 0 for an isometry
    double total = 0;          // the larger, the better
};

/// What counts how much besides curvature, whose weight is 1. Round numbers, fitted by pairwise ranking of
/// right against wrong maps: among few functions orthogonality tells most, among many commutativity.
struct ScoreWeights {
    int curvature_scale;  // 0 = finest .. 3
    double orientation, orthogonality, commutativity, rigidity;
};
constexpr ScoreWeights coarse_score{2, 0.15, 2.5, 0, 0.7}, middle_score{1, 0.25, 0, 10, 2},
    fine_score{0, 0.25, 0, 10, 2};

/// Scores of maps between the samples and the functional maps fitted to them.
Scores score_maps(const SampledPair& pair, const PairedMaps& maps, const PairedFunctionalMaps& functional,
                  const ScoreWeights& weights);

}  // namespace counterpart::spectral_match
