// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What tells a right map from a mirrored, half-turned or twisted one. No single score is enough.
#pragma once

#include "match/spectral/priors.hpp"

#include <limits>

namespace counterpart::spectral_match {

using namespace numerics;
using namespace spectral;  // this matcher is written in its terms

/// For each distance sample that is one of the first n samples: those of the n within a geodesic radius.
struct Neighborhoods {
    std::vector<std::size_t> first;  // where each one's begin; one more at the end
    std::vector<Index> samples;

    Neighborhoods(const PreparedShape& shape, std::size_t n, double radius);
};

constexpr auto all_samples = std::numeric_limits<std::size_t>::max();

/// Both shapes on their first n samples, with neighborhoods on which maps should be rigid, and what is known
/// of the map between them.
struct SampledPair {
    const PreparedShape& a;
    const PreparedShape& b;
    SpectralPoints points_a, points_b;
    MatrixF positions_a, positions_b;
    Neighborhoods near_a, near_b;
    const Priors& priors;  // must outlive this

    SampledPair(const PreparedShape& shape_a, const PreparedShape& shape_b, std::size_t n, double radius,
                const Priors& known = nothing_known);
};

/// How well a map keeps what a right map keeps.
struct Scores {
    double curvature = 0;      // correlation of the ranks of smoothed mean curvature under the map
    double orientation = 0;    // +1 preserved, -1 reflected
    double rigidity = 0;       // what the best rotation leaves of neighborhoods: 0 = locally rigid, 1 = not
    double orthogonality = 0;  // |C^T C - I|^2 / k: 0 for an isometry
    double drift = 0;          // sum of C_ij^2 by relative gap of the eigenvalues i and j, over k: 0 likewise
    double total = 0;          // the larger, the better
};

/// Sum of C_ij^2 by the relative gap of the eigenvalues i and j, over k: 0 for an isometry.
double frequency_drift(const SampledPair& pair, const PairedFunctionalMaps& functional);

/// Scores of maps between the samples and the functional maps fitted to them.
Scores score_maps(const SampledPair& pair, const PairedMaps& maps, const PairedFunctionalMaps& functional,
                  const ScoreWeights& weights);

}  // namespace counterpart::spectral_match
