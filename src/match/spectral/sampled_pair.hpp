// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/priors.hpp"

#include <limits>
#include <vector>

namespace counterpart::spectral_match {

using namespace numerics;
using namespace spectral;  // this matcher is written in its terms

constexpr auto all_samples = std::numeric_limits<std::size_t>::max();

/// Both shapes on their first n samples, and what is known of the map between them. All must outlive it.
struct SampledPair {
    const PreparedShape& a;
    const PreparedShape& b;
    const Priors& priors;
    SpectralPoints points_a, points_b;

    SampledPair(const PreparedShape& shape_a, const PreparedShape& shape_b, std::size_t n,
                const Priors& known = nothing_known);
};

/// Of the first n samples.
MatrixF sample_positions(const PreparedShape& shape, Index n);

/// For each distance sample that is one of the first n samples: those of the n within a geodesic radius.
std::vector<std::vector<Index>> neighborhoods(const PreparedShape& shape, std::size_t n, double radius);

}  // namespace counterpart::spectral_match
