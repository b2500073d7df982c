// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart {

/// The points' numbers in the order of the Morton curve through their bounding cube: neighbours in space
/// mostly lie near each other in it. Ties (equal cells, 2^20 along each axis) by number. O(N log N).
std::vector<Index> space_filling_order(const Points& points);

}  // namespace counterpart
