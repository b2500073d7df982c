// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <algorithm>
#include <string>

namespace counterpart {

struct PlaceOptions {
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

struct PlaceResult {
    VertexMap target_from_source;
    /// Per source vertex, in [0, 1]: 1 where vertices lie at the same places and faces confirm it; else at
    /// most 0.95, less the farther the other surface is, 0 from `reach` on.
    Vector confidence;
    /// The vertices of either mesh lie at the places of the other's, and their edges agree.
    bool same_vertices = false;
    /// Shares of the area of each surface from which the other, facing the same way, is within `reach`.
    double source_share = 0, target_share = 0;
    /// Of what the other surface passes by within four times the reach, facing the same way, the share within
    /// reach; the smaller one of both surfaces. Nearly 1 where one shows a part of the other.
    double agreement = 0;
    double reach = 0;      ///< mesh units: a quarter of the mean edge, but 0.5 to 2 % of sqrt(area)
    std::string sentence;  ///< what was found
};

/// The share of a surface from which it lies in the same place as the other; of one that shows a part of the
/// other, which could as well be a part of something else: of two roughly aligned faces 0.95 lie near.
inline constexpr double coinciding_share = 0.9, part_share = 0.97;
/// Whether one of the surfaces lies on the other: both are the same, or one shows a part of the other.
inline bool coincides(const PlaceResult& result) {
    const auto [less, more] = std::minmax(result.source_share, result.target_share);
    return result.same_vertices || less >= coinciding_share ||
           (more >= part_share && result.agreement >= coinciding_share);
}

/// Matches what lies in the same place, as the meshes are: a retopology, another triangulation or another
/// export of one surface, or a part of it. Vertices at the same places are partners. Otherwise each source
/// vertex takes the closest point that faces the same way (normals less than 60 degrees apart), on the
/// component where most of its own component lies, and there the nearest corner; where the target shows only
/// a part of the source, what it does not reach is unmatched (-1). Meshes that do not coincide are matched
/// all the same: see `coincides`. Throws InvalidInput for invalid meshes, UnsuitableMesh without area,
/// Canceled. O(F log F).
PlaceResult match_place(MeshView source, MeshView target, const PlaceOptions& options = {});

}  // namespace counterpart
