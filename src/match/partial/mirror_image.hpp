// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::partial_match {

/// The mesh in a mirror that keeps the directions up and facing (zero = any); its outside stays outside.
TriangleMesh mirror_image(MeshView mesh, const Eigen::Vector3d& up, const Eigen::Vector3d& facing);

}  // namespace counterpart::partial_match
