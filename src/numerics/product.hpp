// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/product_search.hpp"

namespace counterpart::numerics {

/// a * b and a^T * b in single precision, with the widest vectors the machine has (Eigen uses those it was
/// compiled for). Every sum runs in one fixed order without fused operations: the result is the same on every
/// machine and for any number of threads. O(rows * inner * columns).
MatrixF product(const MatrixF& a, const MatrixF& b);
MatrixF transposed_product(const MatrixF& a, const MatrixF& b);

}  // namespace counterpart::numerics
