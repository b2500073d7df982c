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

struct InvertOptions {
    /// Target vertices farther than this from the image of the source are unmatched; in mean edge lengths of
    /// the target, above 0.
    double reach = 3;
    int n_threads = 0;
};

/// source_from_target: the closest point of the source's image (the source's triangles at their images'
/// positions) to each target vertex, among the triangles whose images are near it along the target's surface.
/// A target vertex that is the image of exactly one source vertex goes back to it. Triangles with an
/// unmatched corner are left out. O(V) for meshes of similar resolution.
SurfaceMap invert(const SurfaceMap& target_from_source, const TriangleMesh& source,
                  const TriangleMesh& target, const InvertOptions& options = {});

}  // namespace counterpart
