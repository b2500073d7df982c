// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/exact.hpp>

namespace counterpart::exact {

/// The match of two meshes that have polygons, wherever these begin and however they were cut.
ExactResult match_polygons(MeshView source, MeshView target, const ExactOptions& options);

/// The match of two meshes whose quads are not known, of one or of both, and cut along different diagonals;
/// where they differ otherwise its `difference` says how, or nothing where that was not looked at (see
/// find_recut_quads).
ExactResult match_recut(MeshView source, MeshView target, const ExactOptions& options);

}  // namespace counterpart::exact
