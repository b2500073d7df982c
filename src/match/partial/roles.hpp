// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/partial.hpp>

namespace counterpart::partial_match {

/// How open a surface is: length of its boundary, over the square root of its area.
double openness(MeshView mesh);

/// Which of the meshes is a part, by their openness.
Part seen_part(MeshView source, MeshView target);

}  // namespace counterpart::partial_match
