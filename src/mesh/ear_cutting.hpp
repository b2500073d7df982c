// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <array>
#include <span>
#include <vector>

namespace counterpart::mesh {

/// Cuts a polygon into size - 2 triangles of its corners, counted from 0: a fan around corner 0 where that is
/// convex seen along the polygon's normal (Newell), else ear by ear, the best shaped one first. Bridges to
/// holes and repeated vertices are allowed. Of what intersects itself some triangles lie over others.
std::vector<std::array<Index, 3>> cut_polygon(PointsView vertices, std::span<const Index> polygon);

}  // namespace counterpart::mesh
