// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"

#include <counterpart/align/transform.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/morph.hpp>

#include <fmt/format.h>

namespace counterpart {

LastPose last_pose(MeshView first, MeshView last, const SurfaceMap& last_from_first) {
    require_valid(last_from_first, first.n_vertices(), last.n_triangles());
    const Points images = image_positions(last_from_first, last);
    std::vector<Index> matched;
    for (Index v = 0; v < first.n_vertices(); ++v)
        if (last_from_first[v].matched()) matched.push_back(v);
    if (static_cast<Index>(matched.size()) == first.n_vertices()) return {images};
    const Affine whole = fit_transform(Points(first.vertices(matched, Eigen::all)),
                                       Points(images(matched, Eigen::all)), TransformModel::similarity);
    const Points moved = whole(first.vertices);
    const mesh::FillResult fill = mesh::fill_from_neighbors(Adjacency(first), images - moved);
    if (fill.unknown > 0)
        throw InvalidInput(fmt::format(
            "{} vertices lie in components without any matched vertex; complete the map or remove them",
            fill.unknown));
    return {moved + fill.values, fill.filled};
}

}  // namespace counterpart
