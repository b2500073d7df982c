// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct InvertOptions {
    /// Target vertices farther than this from the image of the source are unmatched; in mean edge lengths of
    /// the target, above 0.
    double reach = 3;
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

/// source_from_target: for each target vertex the closest point of the source's image (the source's
/// triangles, with corners at their images), among the triangles whose images are near it along the target's
/// surface. A target vertex that is the image of exactly one source vertex maps back to it. Triangles with an
/// unmatched corner are left out, as are those that bridge a tear of the map: their edges are far longer than
/// its stretch explains. O(V) for meshes of similar resolution.
SurfaceMap invert(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                  const InvertOptions& options = {});

struct WithInverseOptions {
    /// How far the round trip of a source vertex may end from it, in mean edge lengths of the source; above
    /// 0.
    double tolerance = 0.25;
    int rounds = 10;      ///< maximum number of rounds, 0 .. 100
    double reach = 3;     ///< see InvertOptions
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

/// A map and its inverse.
struct MapPair {
    SurfaceMap target_from_source, source_from_target;
    Index moved = 0;  ///< images moved in the last round
};

/// The map and its inverse, made consistent: where the round trip deviates more than `tolerance`, for example
/// where the map is torn between legs that touch, the vertex's image moves to where the inverse of the
/// inverse takes it, if its round trip deviates less. A map between meshes of the same connectivity stays as
/// it is.
MapPair with_inverse(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                     const WithInverseOptions& options = {});

}  // namespace counterpart
