// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct InvertOptions {
    /// Target vertices farther than this from the image of the source are unmatched; in mean edge lengths of
    /// the target, above 0.
    double reach = 3;
    int n_threads = 0;
};

/// source_from_target: the closest point of the source's image (the source's triangles at their images'
/// positions) to each target vertex, among the triangles whose images are near it along the target's surface.
/// A target vertex that is the image of exactly one source vertex goes back to it. Triangles with an
/// unmatched corner are left out, and those that bridge a tear of the map, having edges far longer than its
/// stretch explains. O(V) for meshes of similar resolution.
SurfaceMap invert(const SurfaceMap& target_from_source, const TriangleMesh& source,
                  const TriangleMesh& target, const InvertOptions& options = {});

struct WithInverseOptions {
    /// How far from a source vertex the way there and back may end, in mean edge lengths of the source, above
    /// 0.
    double tolerance = 0.25;
    int rounds = 10;   ///< at most; 0 .. 100
    double reach = 3;  ///< see InvertOptions
    int n_threads = 0;
};

/// A map and its inverse.
struct MapPair {
    SurfaceMap target_from_source, source_from_target;
    Index moved = 0;  ///< images moved in the last round
};

/// The map and its inverse, made to agree: where there and back ends farther than `tolerance` from where it
/// started, as where the map is torn between legs that touch, the vertex' image moves to where the inverse,
/// inverted, sends it, if that ends nearer. A map of one connectivity stays as it is.
MapPair with_inverse(const SurfaceMap& target_from_source, const TriangleMesh& source,
                     const TriangleMesh& target, const WithInverseOptions& options = {});

}  // namespace counterpart
