// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What tells a right map from one that is turned half round or exchanges limbs, once both are refined: a map
// must fit before fine relief can speak.
#pragma once

#include "match/spectral/scores.hpp"

#include <array>

namespace counterpart::spectral_match {

/// Of a map between all vertices, mean of both directions.
struct Cues {
    std::array<double, 4> relief{};  // see relief_correlations
    double residual =
        0;  // median over neighborhoods of what the best similarity leaves: 0 = a similarity, 1 = not
    double wring =
        0;  // how fast the rotations of neighborhoods change over some distance, where they change most
};

/// Of PreparedShape::relief under the map, mean of both directions.
std::array<double, 4> relief_correlations(const PreparedShape& a, const PreparedShape& b,
                                          const PairedMaps& on_vertices);

double mean_relief(const std::array<double, 4>& correlations);

/// Mean cosine between normals and those of their images, after the best rotation of each neighborhood of
/// that radius; mean of both directions. A half-turned limb bends the wrong way.
double agreement_of_normals(const PreparedShape& a, const PreparedShape& b, const PairedMaps& on_vertices,
                            double radius);

/// `pair` with neighborhoods of CueTuning::radius.
Cues measure_cues(const SampledPair& pair, const PairedMaps& on_vertices, const CueTuning& tuning = {});

}  // namespace counterpart::spectral_match
