// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <filesystem>
#include <utility>
#include <vector>

namespace counterpart {

/// Reads pairs (source vertex, target vertex) that are known to correspond: text with one pair per line,
/// either two 0-based vertices or six coordinates (a point near the source, then one near the target; the
/// closest vertices are taken, the first of equals). '#' starts a comment. Throws IoError naming file, line
/// and reason: anything else on a line, a vertex that does not exist, no pair at all.
std::vector<std::pair<Index, Index>> read_landmarks(const std::filesystem::path& file, MeshView source,
                                                    MeshView target);

}  // namespace counterpart
