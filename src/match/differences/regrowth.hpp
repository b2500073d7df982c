// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/differences/growth.hpp"
#include "match/differences/prediction.hpp"

#include <functional>

namespace counterpart::differences {

/// Goes on from the border of what is matched, layer by layer: an unmatched vertex takes the free target
/// vertex, of those within two edges of the images of its neighbors, that lies closest to where its anchors
/// expect it, if that is near enough; triangles that this matches and equal colors count for a shorter
/// distance. So vertices are found where every triangle around them was changed. O(unmatched).
std::vector<Index> regrown(const PairSide& source, const PairSide& target, std::vector<Index> map,
                           Prediction& prediction, const std::function<void()>& report);

}  // namespace counterpart::differences
