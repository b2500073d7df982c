// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace counterpart {

struct UvOptions {
    /// The texture coordinates of both meshes, n x 2 values each, within 1e6 of 0. Needed.
    CornerAttribute source{}, target{};
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

struct UvResult {
    VertexMap target_from_source;  ///< the nearest corners of `surface`
    SurfaceMap surface;            ///< the points of the target with the source vertices' coordinates
    /// Per source vertex, in [0, 1]: at most 0.95, less the farther outside the target's charts its
    /// coordinates lie; half of it where charts lie over one another and place chose one; 0 where coordinates
    /// at a seam lead to places apart, and for unmatched vertices.
    Vector confidence;
    /// Of the vertices of either mesh that have texture coordinates, the share that lies in a chart of the
    /// other.
    double source_share = 0, target_share = 0;
    /// Of the source vertices at seams, the share whose coordinates all lead to one place; 1 if there are
    /// none.
    double seam_agreement = 1;
    Index n_by_place = 0;   ///< source vertices for which place chose between charts over one another
    Index n_undecided = 0;  ///< those for which it could not: they are unmatched
    double reach = 0;       ///< how far outside a chart coordinates may lie, in units of texture coordinates
    std::string sentence;   ///< what was found
};

/// Whether both meshes are laid out alike: one's vertices lie in the other's charts, and seams close.
inline constexpr double alike_share = 0.9;
inline bool laid_out_alike(const UvResult& result) {
    return std::max(result.source_share, result.target_share) >= alike_share &&
           result.seam_agreement >= alike_share;
}

/// Matches meshes that share a layout of texture coordinates, in any poses: each source vertex takes the
/// point of the target with its coordinates, or the nearest one within `reach` outside of a chart (a chart:
/// triangles that are joined in the layout and face one way in it). Charts that face the other way, as those
/// of mirrored halves do, never meet. Of charts over one another that takes a vertex which is nearest on
/// average, after the similarity that fits all other vertices best, if it is clearly nearest; else, and where
/// more than 64 places have its coordinates, the vertex is unmatched. Where layouts differ the map is wrong:
/// see `laid_out_alike`. Throws InvalidInput for invalid meshes, missing or invalid coordinates, and where
/// nothing of one layout lies over the other; Canceled. O(F log F) for charts of which few lie over one
/// another.
UvResult match_uv(MeshView source, MeshView target, const UvOptions& options);

/// What speaks for and against the map, as match adds it to its messages.
std::vector<Message> uv_messages(const UvResult& result);

}  // namespace counterpart
