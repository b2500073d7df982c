// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/coarse_shape.hpp"
#include "match/spectral/map.hpp"

namespace counterpart::spectral_match {

/// Coarse copies of both shapes of a level, with a level of their own.
struct CoarsePair {
    CoarseShape a, b;
    Priors priors;
    Level level;

    CoarsePair(const Level& whole, Index n_vertices)
        : a(coarsened(whole.a.shape, n_vertices, whole.tuning.preparation)),
          b(coarsened(whole.b.shape, n_vertices, whole.tuning.preparation)),
          priors(coarsened(whole.pair.priors, a, b)),
          level(a.shape, b.shape, priors, whole.tuning) {}
    CoarsePair(const CoarsePair&) = delete;
    CoarsePair& operator=(const CoarsePair&) = delete;
};

}  // namespace counterpart::spectral_match
