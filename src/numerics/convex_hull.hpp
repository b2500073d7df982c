// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart::numerics {

/// Which points lie approximately on the convex hull of all: those that are farthest in one of 2000 evenly
/// spread directions (about 4 degrees apart), or nearer than the farthest by at most `tolerance` times the
/// cloud's greatest distance from its mean. O(N).
std::vector<bool> on_convex_hull(PointsView points, double tolerance);

}  // namespace counterpart::numerics
