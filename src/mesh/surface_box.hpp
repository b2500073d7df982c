// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <Eigen/Geometry>

namespace counterpart::mesh {

/// The box around the surface, in mesh units: vertices in no triangle are no part of it. Around all vertices
/// where there is no triangle. O(V + F).
Eigen::AlignedBox3d surface_box(MeshView mesh);

}  // namespace counterpart::mesh
