// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct ProjectOptions {
    /// Rings of source vertices whose images are averaged, 1 .. 5.
    int rings = 2;
    /// How often the images are evened out, 1 .. 100.
    int passes = 3;
    /// Rounds in which unmatched vertices near matched ones get the image that the fit through their
    /// neighbours gives, 0 .. 1000. Each reaches `rings` rings into the unmatched part.
    int extend = 0;
    /// Vertices whose surrounding triangles all go to triangles of the target stay where they are if at least
    /// this share of the source's triangles does, 0 .. 1: the meshes then have one connectivity.
    double exact_share = 0.5;
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};

/// From vertices to points between them. Each source vertex's image is estimated from the images around it -
/// a plane is fitted through them by moving least squares over the source's tangent plane (Lancaster and
/// Salkauskas 1981), which evens out the half edge by which each vertex image is off - and projected onto the
/// target's triangles around those images. Unmatched vertices stay unmatched unless `extend` says otherwise.
/// O(V) for bounded valences.
SurfaceMap project_map(const TriangleMesh& source, const TriangleMesh& target,
                       const VertexMap& target_from_source, const ProjectOptions& options = {});

}  // namespace counterpart
