// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart::numerics {

/// Spearman's rank correlation of two lists of numbers of one length, -1 to 1; of equal numbers the first is
/// the smaller. 0 for less than two. O(n log n).
double rank_correlation(const Vector& first, const Vector& second);

}  // namespace counterpart::numerics
