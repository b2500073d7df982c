// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/combinatorial_map.hpp"

#include <utility>
#include <vector>

namespace counterpart {

struct PartialMatch {
    std::vector<Index> image;     ///< local target vertex of each local source vertex, or -1
    std::vector<bool> contested;  ///< source vertices for which another pair had much the same evidence
    bool turned = false;          ///< the surfaces are wound against each other
    bool ambiguous = false;       ///< another way to match had nearly as much evidence as a whole
};

/// Grows a vertex matching from every unambiguous seed. `settled` are flags of triangles that correspond
/// already (islands that are the same): their vertices are fixed first.
PartialMatch grow_matching(const TriangleMesh& source_mesh, const TriangleMesh& target_mesh,
                           const CombinatorialMap& source, const CombinatorialMap& target,
                           const std::vector<std::pair<Flag, Flag>>& settled);

}  // namespace counterpart
