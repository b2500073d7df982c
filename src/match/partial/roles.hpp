// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/partial.hpp>

namespace counterpart::partial_match {

/// How open a surface is: length of its boundary, over the square root of its area.
double openness(MeshView mesh);

/// A mesh is taken for a part if it is more open than this: parts of the SHREC'16, PFAUST and PARTIALSMAL
/// sets have 0.9 and more, whole shapes with open eyes, mouths or soles up to 0.6.
constexpr double open_part = 0.7;

/// Below this a boundary is no opening but a seam or a slit, as where one vertex lies at the place of
/// another.
constexpr double least_opening = 0.1;
inline bool has_opening(MeshView mesh) { return openness(mesh) >= least_opening; }

/// Which of the meshes is a part, by their openness.
Part seen_part(MeshView source, MeshView target);

}  // namespace counterpart::partial_match
