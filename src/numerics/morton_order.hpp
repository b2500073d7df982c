// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart::numerics {

/// The points' indices in the order of the Morton curve through their bounding cube: points that are near in
/// space are mostly near in this order. Ties (equal cells, 2^20 along each axis) by number. O(N log N).
std::vector<Index> space_filling_order(PointsView points);

}  // namespace counterpart::numerics
