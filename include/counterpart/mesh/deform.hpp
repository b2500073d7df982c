// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>

namespace counterpart {

/// The mesh's longest, middle and thinnest direction are the principal axes of its surface.
struct DeformOptions {
    double bend = 0;   ///< radians between the two ends of the longest direction, bent towards the thinnest;
                       ///< -2 pi .. 2 pi
    double twist = 0;  ///< radians between the two ends, turned around the longest direction; -2 pi .. 2 pi
    double warp = 0;   ///< size of a smooth random displacement, as a fraction of the length; 0 .. 0.5
    std::uint64_t seed = 1;  ///< of the displacement
};

/// The same mesh in another pose: twisted, bent, then warped. The same vertices and triangles in the same
/// order. Bending and twisting keep lengths near the central axis and change them by a fraction of about
/// angle * distance from the axis / length away from it. O(V). Throws InvalidInput for an invalid mesh or
/// options out of range.
TriangleMesh deform(const TriangleMesh& mesh, const DeformOptions& options);

}  // namespace counterpart
