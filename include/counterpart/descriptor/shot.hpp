// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>

namespace counterpart {

struct ShotOptions {
    double radius = 0;  ///< of the neighborhood, mesh units; above 0; a tenth of sqrt(area) is usual
    /// The surface is described by points about this far apart, not by its vertices; mesh units, 0 = radius
    /// / 15.
    double spacing = 0;
    int n_threads = 0;  ///< 0 = all; does not change the result
};

/// Signatures of histograms of orientations (SHOT; Tombari, Salti, Di Stefano 2010): vertices.size() x 320,
/// each row of length 1 (0 where there is nothing within the radius). Row i describes how the normals of the
/// surface near vertices[i] are turned, in a local frame: 8 sectors x 2 hemispheres x 2 shells x 10 bins of
/// the cosine. The frame is right-handed, so mirror images differ. Independent of position and rotation and,
/// with neighborhoods that are weighted by area, of the triangulation. Throws InvalidInput for an invalid
/// mesh or vertex and for options out of range. O(vertices.size() * points within the radius).
Matrix shot(MeshView mesh, std::span<const Index> vertices, const ShotOptions& options);

}  // namespace counterpart
