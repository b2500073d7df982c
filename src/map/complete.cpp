// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/harmonic_fill.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>

#include <cmath>

#include <fmt/format.h>

namespace counterpart {

CompletedMap complete_map(const SurfaceMap& target_from_source, MeshView source, MeshView target) {
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    CompletedMap result{target_from_source, {.transferred = count_matched(target_from_source)}};
    if (result.coverage.transferred == 0) throw InvalidInput("the map matches no vertex");
    if (result.coverage.transferred == source.n_vertices()) return result;
    const mesh::FillResult images =
        mesh::fill_everywhere(source, image_positions(target_from_source, target));
    result.coverage.filled = images.filled;
    result.coverage.guessed = images.unknown;
    const numerics::ClosestTriangle surface(target.vertices, target.triangles);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v].matched()) continue;
        const numerics::ClosestPoint point = surface.closest(images.values.row(v).transpose());
        if (!std::isfinite(point.squared_distance)) {
            throw InvalidInput(
                fmt::format("the place of vertex {} on the target is too far from it to be "
                            "measured; scale the meshes to smaller coordinates",
                            v));
        }
        result.target_from_source.image[static_cast<std::size_t>(v)] = {point.triangle, point.weights};
    }
    return result;
}

}  // namespace counterpart
