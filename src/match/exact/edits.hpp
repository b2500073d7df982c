// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/difference.hpp>

#include <vector>

namespace counterpart {

/// Groups the triangles without counterpart that share edges, across both meshes, and says what each group
/// looks like. `difference` holds the map and the lists of what is unmatched.
std::vector<Edit> find_edits(const TriangleMesh& source, const TriangleMesh& target,
                             const MeshDifference& difference);

}  // namespace counterpart
