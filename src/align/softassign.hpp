// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The softassign step of Chui and Rangarajan 2003, section 3: Gaussian weights of all pairs, an outlier row
// and column, and Sinkhorn's alternating normalization.
#pragma once

#include <counterpart/base/types.hpp>

#include <cstddef>
#include <vector>

namespace counterpart::align {

struct SoftassignOptions {
    double outlier_temperature = 1;  ///< T0: width and height of the two outlier Gaussians
    int max_sinkhorn = 10;           ///< rounds of row and column normalization
    double tolerance = 0.01;         ///< stop when no row sum is off by more
};

/// Single precision, vectorized, no allocation per update. Each update starts Sinkhorn from the scales of the
/// one before, which are nearly right when points and temperature have changed a little. The matrix is kept
/// as diag(u) E diag(v): Sinkhorn then only reads E, once per round.
class Softassign {
  public:
    /// `target`: M x D, D = 2 or 3; `n_source` rows.
    Softassign(const Matrix& target, Eigen::Index n_source, const SoftassignOptions& options);

    /// Assignment of the transformed source points (N x D) to the target at temperature T:
    /// m_ij = exp(-|f_i - y_j|^2 / 2T) / T, outliers exp(-|f_i - center|^2 / 2 T0) / T0, then Sinkhorn.
    void update(const Matrix& transformed, double temperature);

    /// Row i: sum over j of m_ij y_j / sum over j of m_ij; a row without weight keeps `fallback`'s.
    Matrix means(const Matrix& fallback) const;
    /// N x M, without the outlier row and column.
    Matrix matrix() const;
    /// Mean over the rows of their largest entry over their sum: 1 when the assignment is hard.
    double hardness() const;

  private:
    SoftassignOptions options_;
    std::size_t n_, m_, stride_;  // stride: m rounded up to whole vectors, padded with weight 0
    Eigen::Index dimension_;
    std::vector<float> target_;  // 3 rows of `stride_`; z is 0 in 2D
    Eigen::RowVectorXd target_center_;
    std::vector<float> weights_;  // E
    std::vector<float> row_outlier_, col_outlier_;
    std::vector<float> u_, v_, column_sums_;
};

}  // namespace counterpart::align
