// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/tuning.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::partial_match {

/// Vertices of edges that a map tears: whose ends, neighbors on the mesh, go to places far apart. A surface
/// that is fused with itself, as where a hand touches a hip, must be torn there. `places` are those of the
/// vertices' images, in units of the image's sqrt(area). Increasing. O(F).
std::vector<Index> torn_vertices(MeshView mesh, const Points& places, const TearTuning& tuning);

}  // namespace counterpart::partial_match
