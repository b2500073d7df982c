// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/transfer/complete_map.hpp>
#include <counterpart/transfer/fill.hpp>

namespace counterpart {

CompletedMap complete_map(const SurfaceMap& target_from_source, const TriangleMesh& source,
                          const TriangleMesh& target) {
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    CompletedMap result{target_from_source, {.carried = count_matched(target_from_source)}};
    if (result.coverage.carried == 0) throw InvalidInput("the map matches no vertex");
    if (result.coverage.carried == source.n_vertices()) return result;
    const FillResult images = fill_everywhere(source, image_positions(target_from_source, target));
    result.coverage.filled = images.filled;
    result.coverage.guessed = images.unknown;
    const ClosestTriangle surface(target.vertices, target.triangles);
    for (Index v = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v].matched()) continue;
        const ClosestPoint point = surface.closest(images.values.row(v).transpose());
        result.target_from_source.image[static_cast<std::size_t>(v)] = {point.triangle, point.weights};
    }
    return result;
}

}  // namespace counterpart
