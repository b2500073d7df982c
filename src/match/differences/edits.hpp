// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/differences.hpp>

#include <vector>

namespace counterpart::differences {

/// Groups the triangles without counterpart that share edges, across both meshes, and says what each group
/// looks like. `differences` holds the map and the lists of what is unmatched.
std::vector<Edit> find_edits(MeshView source, MeshView target, const MeshDifferences& differences);

}  // namespace counterpart::differences
