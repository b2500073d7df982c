// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart::numerics {

/// Row-major single precision: enough for nearest neighbors, half the memory traffic.
using MatrixF = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using VectorF = Eigen::VectorXf;

struct BestPartners {
    std::vector<Index> of_row, of_column;
};

/// With S = x * y^T (x: n x d, y: m x d), the column j that maximizes S(i, j) - column_bias[j] for every row
/// i, and the row i that maximizes S(i, j) - row_bias[i] for every column j; ties by smallest number. With
/// biases of half the squared lengths these are the nearest neighbors. S is never stored. Every sum runs in
/// one fixed order without fused operations: the result is the same on every machine and for any number of
/// threads. O(n m d). Throws NumericalError if all of y is NaN.
BestPartners best_partners(const MatrixF& x, const MatrixF& y, const VectorF& row_bias,
                           const VectorF& column_bias);

}  // namespace counterpart::numerics
