// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/similarity.hpp"

#include <functional>
#include <vector>

namespace counterpart {

/// The target of each source, -1 for those left over; the smaller side is wholly assigned. `cost(i, j)` is
/// what pairing them costs, not less than the squared distance from where the source is expected to the
/// target: that tells which pairs are worth a look. Optimal for at most 400 on the larger side. Beyond that,
/// closest pairs first among the 16 nearest, then exchanges between neighbours while they lower the sum: O(n
/// log n), not optimal.
std::vector<Index> assign_islands(const Points& expected_sources, const Points& targets,
                                  const std::function<double(Index, Index)>& cost);

/// A motion of one cloud of centres onto the other when nothing is known: the best by mean distance to the
/// closest centre of: translation and scaling alone; and principal axes onto principal axes, four ways.
Motion align_centers(const Points& sources, const Points& targets);

}  // namespace counterpart
