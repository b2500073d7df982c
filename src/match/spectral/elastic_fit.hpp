// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress_range.hpp"
#include "match/spectral/tuning.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

#include <memory>
#include <vector>

namespace counterpart::spectral_match {

/// Moves a surface towards given positions while its neighborhoods stay as similar as possible (Sorkine and
/// Alexa 2007, with soft positions and a scale for each neighborhood).
class ElasticFit {
  public:
    /// Of `tuning` the bounds of a neighborhood's scale, and when a fit has settled.
    ElasticFit(PointsView rest, const LaplaceBeltrami& laplacian, const RefinementTuning& tuning = {});
    ~ElasticFit();

    /// Lowers sum w_ij |(x_i - x_j) - s_i R_i (rest_i - rest_j)|^2 + mu sum m_i |x_i - towards_i|^2 in turns
    /// over similarities and positions, from x = `start`. Positions are followed on features longer than
    /// `stiffness_length` = mu^-1/2, in mesh units; neighborhoods stay similar below it. Ends when it has
    /// settled, or after `n_iterations`. `trust`, if not empty, multiplies the pull on each vertex. Rotations
    /// are followed from those of the last call, which saves time where its positions were near.
    Points operator()(PointsView towards, PointsView start, double stiffness_length, int n_iterations,
                      const ProgressRange& progress = {}, const Vector& trust = {});

    /// Where the surface that lies at `towards` carries its `spoiled` vertices, which pull at nothing
    /// themselves: their neighborhoods are turned as those around them. A start for the next call, which
    /// follows these rotations.
    Points carried(PointsView towards, const std::vector<char>& spoiled, double stiffness_length);

    /// What the best similarity of each neighborhood leaves of `now`, relative to its size: 0 = a similarity
    /// everywhere, at most 1.
    double strain(PointsView now) const;

  private:
    struct System;
    std::unique_ptr<System> system_;
};

}  // namespace counterpart::spectral_match
