// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::place {

/// Of each source vertex the target vertex where it lies.
struct Closest {
    std::vector<Index> vertex;
    std::vector<double> squared_distance;  ///< to the closest point that faces the same way
};

/// The corner nearest to the closest point that faces the same way, on the component of the target where most
/// of the source's own component finds points within reach: so parts that touch are not mixed up. Where there
/// is none, on all of the target; where nothing faces the same way, the closest point.
Closest closest_part_by_part(MeshView source, MeshView target, double reach);

}  // namespace counterpart::place
