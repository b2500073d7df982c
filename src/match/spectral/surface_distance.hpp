// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <algorithm>

namespace counterpart::spectral_match {

/// A lower bound of the distance between two vertices along edges: the straight distance, or the largest
/// difference of their distances from up to 32 samples that reach both (triangle inequality; Goldberg and
/// Harrelson 2005). Large between two legs side by side. The shape needs at least one row of distances and
/// must outlive this. O(samples) each.
class SurfaceDistanceBound {
  public:
    explicit SurfaceDistanceBound(const PreparedShape& shape)
        : positions_(shape.mesh.vertices),
          from_samples_(shape.sample_distances.topRows(std::min(n_samples, shape.sample_distances.rows()))
                            .transpose()) {}

    double operator()(Index v, Index w) const {
        const auto x = from_samples_.row(v).array(), y = from_samples_.row(w).array();
        const double along = (x.max(y) < unreachable).select((x - y).abs(), 0.0F).maxCoeff();
        return std::max(along, (positions_.row(v) - positions_.row(w)).norm());
    }

  private:
    static constexpr Eigen::Index n_samples = 32;

    const Points& positions_;
    const MatrixF from_samples_;  // vertices x samples
};

}  // namespace counterpart::spectral_match
