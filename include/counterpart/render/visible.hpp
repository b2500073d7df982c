// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/render/camera.hpp>

#include <vector>

namespace counterpart::render {

/// Whether a camera far away sees each triangle: the middle of its front, with nothing before it. What a
/// scanner gets from one side; see part_of. O(F log F). Throws InvalidInput for an invalid mesh.
std::vector<char> visible_triangles(MeshView mesh, const Camera& view);

}  // namespace counterpart::render
