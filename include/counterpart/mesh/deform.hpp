// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>

namespace counterpart {

/// The mesh's longest, middle and shortest axes are the principal axes of its surface.
struct DeformOptions {
    double bend = 0;   ///< radians between the two ends of the longest axis, bent toward the shortest;
                       ///< -2 pi .. 2 pi
    double twist = 0;  ///< radians between the two ends, about the longest axis; -2 pi .. 2 pi
    double warp = 0;   ///< size of a smooth random displacement, as a fraction of the mesh's length; 0 .. 0.5
    std::uint64_t seed = 1;  ///< of the displacement
};

/// The same mesh in another pose: twisted, bent, then warped. Keeps vertices and triangles in order. Bending
/// and twisting preserve lengths near the central axis and change them by a fraction of about angle *
/// distance from the axis / length away from it. O(V). Throws InvalidInput for an invalid mesh or options out
/// of range.
TriangleMesh deform(MeshView mesh, const DeformOptions& options);

}  // namespace counterpart
