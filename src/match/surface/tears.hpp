// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <algorithm>
#include <vector>

namespace counterpart::surface_match {

/// How far an edge is torn: what its image is longer than twice the edge.
inline double tear(double before, double after) { return std::max(0.0, after - 2 * before); }

/// Neighbors are torn apart if their edge is torn by more than this, in units of sqrt(area).
constexpr double torn_apart = 0.08;

/// Vertices of edges that a map tears apart. A surface that is fused with itself, as where a hand touches a
/// hip, must be torn there. `places` are those of the vertices' images, in units of the image's sqrt(area).
/// Increasing. O(F).
std::vector<Index> torn_vertices(MeshView mesh, const Points& places);

}  // namespace counterpart::surface_match
