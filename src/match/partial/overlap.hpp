// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/one_way_fit.hpp"

#include <vector>

namespace counterpart::partial_match {

/// Who has a partner once the part lies on the other surface: -1 for those that have none.
struct PartnerMaps {
    std::vector<Index> whole_from_part, part_from_whole;
    /// Of the area that does not lie beyond the other surface's boundary, the share without a partner: where
    /// parts overlap, all of that should have one. The larger of both; 0 if the part is covered.
    double misfit = 0;
};

/// Steps 7 and 8. A vertex is paired with the closest in place and normal on the other surface, unless that
/// is too far, or lies on the boundary while the vertex is beyond it. If the whole surface has a place for
/// all of the part (`part_is_covered`), every vertex of the part is paired; else islands are left out.
PartnerMaps partners(const Surface& part, const Surface& whole, const BentSource& bent, bool part_is_covered,
                     const OverlapTuning& tuning, const IslandTuning& island_tuning);

}  // namespace counterpart::partial_match
