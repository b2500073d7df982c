// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <algorithm>

namespace counterpart::spectral_match {

/// Distances along a surface, from below: not less than straight through space, nor than what the distances
/// from any of `n_samples` samples differ by (triangle inequality; Goldberg and Harrelson 2005). Tells two
/// legs that touch from one. O(samples) each.
class SurfaceDistance {
  public:
    explicit SurfaceDistance(const PreparedShape& shape)
        : positions_(shape.mesh.vertices),
          from_samples_(shape.sample_distances.topRows(std::min(n_samples, shape.sample_distances.rows()))
                            .transpose()) {}

    double operator()(Index v, Index w) const {
        const double along = (from_samples_.row(v) - from_samples_.row(w)).cwiseAbs().maxCoeff();
        return std::max(along, (positions_.row(v) - positions_.row(w)).norm());
    }

  private:
    static constexpr Eigen::Index n_samples = 32;

    const Points& positions_;
    const MatrixF from_samples_;  // vertices x samples
};

}  // namespace counterpart::spectral_match
