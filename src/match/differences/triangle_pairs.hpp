// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a vertex map says about triangles.
#pragma once

#include "match/isomorphism/dart_map.hpp"

#include <counterpart/map/vertex_map.hpp>

#include <array>
#include <vector>

namespace counterpart::differences {

/// The target triangle of each source triangle, each at most once; -1 if there is none. O(F log F).
std::vector<Index> match_triangles(MeshView source, MeshView target, const std::vector<Index>& map);

/// Matched source vertices of which fewer than two triangles, or less than half, have a counterpart, unless
/// all do.
std::vector<Index> weakly_supported(MeshView source, MeshView target, const std::vector<Index>& partner,
                                    const std::vector<Index>& map);

/// Matched source triangles in regions that edges connect, the largest region first.
std::vector<std::vector<Index>> matched_regions(const isomorphism::DartMap& source,
                                                const std::vector<Index>& partner);

/// How many triangles each vertex has, which, and the vertices of each in increasing order, sorted.
std::vector<Index> valences(MeshView mesh);
std::vector<std::vector<Index>> triangles_at_vertices(MeshView mesh);
std::vector<std::array<Index, 3>> sorted_faces(MeshView mesh);

}  // namespace counterpart::differences
