// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::surface_match {

/// How open a surface is: length of its boundary, over the square root of its area. A seam, where vertices
/// lie at one place, is no boundary. O(F log F).
double openness(MeshView mesh);

/// Below this a boundary is no opening but a seam or a slit, as where one vertex lies at the place of
/// another.
constexpr double least_opening = 0.1;
inline bool has_opening(MeshView mesh) { return openness(mesh) >= least_opening; }

}  // namespace counterpart::surface_match
