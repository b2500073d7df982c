// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::place {

/// How much of two surfaces lies in the same place.
struct Coincidence {
    /// How far apart they may be: half a percent of sqrt(area), or a quarter of the mean edge, which is about
    /// what a coarse triangulation of a round surface lacks.
    double reach = 0;
    /// Shares of the area of either surface from which the other, facing the same way, is within reach.
    double source_share = 0, target_share = 0;
    /// Of what the other surface passes by within four times the reach, facing the same way, the share within
    /// reach; the smaller one of both surfaces.
    double agreement = 0;
};

/// Measured from some thousand points, evenly spread. Shares below 0.5 may be rough, and are 0 where the
/// boxes around the meshes lie apart. Throws UnsuitableMesh for meshes without area. O(F log F).
Coincidence measure_coincidence(MeshView source, MeshView target);

}  // namespace counterpart::place
