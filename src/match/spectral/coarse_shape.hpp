// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/priors.hpp"

namespace counterpart::spectral_match {

/// A shape on fewer vertices, to try many maps quickly.
struct CoarseShape {
    PreparedShape shape;                // `full` is the shape that it was made from, for `lift`
    std::vector<Index> fine_of_coarse;  // vertices
    std::vector<Index> coarse_of_fine;
};

/// The shape on a proxy of about `n_vertices`. What is known at its vertices is taken over, samples keep
/// their numbers, so that a map between samples means the same on both; `origin`, of no use here, is left
/// out. Where such a proxy lacks too much of the surface, it has twice
/// as many, and so on; a shape that has no more vertices is kept as it is. About O(V
/// log n_vertices).
CoarseShape coarsened(const PreparedShape& fine, Index n_vertices, const PreparationTuning& tuning = {});

/// What is known of vertices, of the coarse ones nearest to them.
Priors coarsened(const Priors& priors, const CoarseShape& a, const CoarseShape& b);

}  // namespace counterpart::spectral_match
