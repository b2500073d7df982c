// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct ProjectOptions {
    /// Rings of source vertices whose images are averaged, 1 .. 5.
    int rings = 2;
    /// Number of smoothing passes over the images, 1 .. 100.
    int passes = 3;
    /// Rounds of extending the map, 0 .. 1000: unmatched vertices near matched ones get the image that the
    /// fit through their neighbors gives. Each round reaches `rings` rings into the unmatched part.
    int extend = 0;
    /// Vertices whose triangles all map to target triangles keep their images if at least this fraction of
    /// the source's triangles does, 0 .. 1: the meshes then have the same connectivity there.
    double exact_share = 0.5;
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

/// A sub-vertex map from a vertex map. Each source vertex's image is estimated from the images around it and
/// projected onto the target's triangles around those images. The estimate is a linear moving-least-squares
/// fit over the source's tangent plane (Lancaster and Salkauskas 1981), which averages out the error of about
/// half an edge that each vertex image has. Unmatched vertices stay unmatched unless `extend` says otherwise.
/// O(V) for bounded valences.
SurfaceMap project_map(MeshView source, MeshView target, const VertexMap& target_from_source,
                       const ProjectOptions& options = {});

}  // namespace counterpart
