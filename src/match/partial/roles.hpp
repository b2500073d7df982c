// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/partial.hpp>

namespace counterpart::partial_match {

/// A mesh is taken for a part if it is more open than this: parts of the SHREC'16, PFAUST and PARTIALSMAL
/// sets have 0.9 and more, whole shapes with open eyes, mouths or soles up to 0.6.
constexpr double open_part = 0.7;

/// Which of the meshes is a part, by their openness.
Part seen_part(MeshView source, MeshView target);

}  // namespace counterpart::partial_match
