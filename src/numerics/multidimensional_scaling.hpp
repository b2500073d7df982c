// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart::numerics {

/// Points in 3D whose distances approximate the given ones best (n x n, finite, symmetrized here),
/// least squares of the differences: SMACOF (De Leeuw 1977) from the classical solution (Torgerson 1952).
/// Determined up to a rigid motion and reflection. O(n^3) once and O(n^2) per iteration.
Points multidimensional_scaling(const Matrix& distances, int iterations = 50);

}  // namespace counterpart::numerics
