// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/differences/growth.hpp"

namespace counterpart::differences {

/// Matched source vertices of which nothing tells where they belong. Grids and lattices agree with any other:
/// where the meshes have one in common, but end it in different ways (a face that was triangulated anew on a
/// body that was not), each pair follows from the one beside it, and drifts. Such patches begin
/// DifferenceTuning::rings edges from irregular vertices that are matched with all their triangles; they are
/// doubted where they touch what is not shared, unless their lengths agree better than chance gives on the
/// mesh laid on itself. Increasing. `partner`: the target triangle of each source triangle or -1. O(F).
std::vector<Index> untold_vertices(const PairSide& source, MeshView target, const std::vector<Index>& map,
                                   const std::vector<Index>& partner);

}  // namespace counterpart::differences
