// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/closest_triangle.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::place {

/// Cosine of the angle up to which two surfaces face the same way.
inline constexpr double same_way = 0.5;

/// A mesh to which the closest points are asked.
struct Surface {
    MeshView mesh;
    Vector areas;    // of triangles
    Points normals;  // of triangles
    numerics::ClosestTriangle closest;

    explicit Surface(MeshView of);
};

}  // namespace counterpart::place
