// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "align/local_similarities.hpp"
#include "base/progress_range.hpp"

#include <memory>
#include <vector>

namespace counterpart::align {

struct ElasticFitOptions {
    ScaleBounds scales{};
    /// Root mean square step at which a fit ends early, in the units of the rest positions; 0 = never.
    double settled = 0;
    int n_kept_factors = 1;  ///< factorizations kept for pulls that come again, at least 1
};

/// A surface that keeps the shape of its neighborhoods up to a rotation and a bounded scale for each while it
/// is drawn to given positions: as-rigid-as-possible deformation (Sorkine and Alexa 2007) with soft positions
/// and scales.
///
/// Rotations are in single precision and followed from those of the last call by a few Newton steps: what
/// matters is where the surface comes to lie, and converged fits match no better.
class ElasticFit {
  public:
    /// `stiffness` (V x V, symmetric) has minus the weight of each edge off its diagonal, whose rows sum to
    /// 0.
    ElasticFit(PointsView rest, const SparseMatrix& stiffness, const ElasticFitOptions& options = {});
    ~ElasticFit();
    ElasticFit(ElasticFit&&) noexcept;

    /// Lowers sum w_ij |(x_i - x_j) - s_i R_i (rest_i - rest_j)|^2 + pull_i |x_i - towards_i|^2 in
    /// `n_iterations` turns over similarities and positions, from x = `start`. A pull of area_i / L^2 is
    /// followed on features longer than about L. Vertices marked in `spoiled`, one entry each or empty, turn
    /// as their surroundings do. Throws NumericalError where nothing holds the surface; Canceled. O(V) each
    /// iteration, and a factorization for a pull that is new.
    Points operator()(PointsView towards, const Vector& pull, PointsView start, int n_iterations,
                      const ProgressRange& progress = {}, const std::vector<char>& spoiled = {});

    /// The next call finds its rotations anew.
    void forget_rotations();

    /// What the best similarity of each neighborhood leaves of `now`, relative to its size: 0 = a similarity
    /// everywhere, at most 1.
    double strain(PointsView now) const;

  private:
    struct System;
    std::unique_ptr<System> system_;
};

}  // namespace counterpart::align
