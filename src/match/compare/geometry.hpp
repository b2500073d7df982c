// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What two meshes have in common besides their connectivity.
#pragma once

#include <counterpart/match/compare.hpp>

#include <optional>
#include <vector>

namespace counterpart::comparison {

/// Fills in all but the connectivity: the reports, scale, axes, place, what is inside out, and messages on
/// what spoils maps. O((V + F) log F).
void compare_geometry(MeshView source, MeshView target, MeshComparison& result);

/// Of meshes of different connectivity: a message if that is the same once vertices at one place are merged.
std::optional<Message> weldable(MeshView source, MeshView target);

}  // namespace counterpart::comparison
