// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/tuning.hpp"

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::partial_match {

/// The map without its islands. A map of two parts holds together where they overlap; what a cut has taken
/// away there may yet lie near something else by chance, far from the images of its neighbors. Matched
/// vertices that edges connect which are not torn apart are a region; of each component of the surface those
/// regions stay that have IslandTuning::min_share of the area of the largest, the others become -1. O(F).
std::vector<Index> without_islands(std::vector<Index> map, MeshView from, MeshView to,
                                   const IslandTuning& tuning);

}  // namespace counterpart::partial_match
