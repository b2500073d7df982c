// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace counterpart::numerics {

using TallMatrix = Eigen::Ref<const Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

/// a^T * b and a * b for matrices a of many rows, in double precision, with the widest vectors the machine
/// has (Eigen uses those it was compiled for). Fastest where b has a multiple of 8 columns. Every sum runs in
/// one fixed order without fused operations: the result is the same on every machine and for any number of
/// threads. O(rows * inner * columns).
Eigen::MatrixXd transposed_times(const TallMatrix& a, const Eigen::MatrixXd& b);
Eigen::MatrixXd times(const TallMatrix& a, const Eigen::MatrixXd& b);

}  // namespace counterpart::numerics
