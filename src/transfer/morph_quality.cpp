// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/transfer/morph.hpp>

#include <algorithm>
#include <cmath>

namespace counterpart {

std::vector<Index> inverted_triangles(TrianglesView triangles, PointsView before, PointsView after) {
    const Points then = triangle_normals({before, triangles}), now = triangle_normals({after, triangles});
    std::vector<Index> inverted;
    for (Index t = 0; t < static_cast<Index>(triangles.rows()); ++t)
        if (now.row(t).dot(then.row(t)) < 0) inverted.push_back(t);
    return inverted;
}

MorphQuality measure_morph(MeshView first, PointsView last, double time, PointsView frame,
                           PointsView before) {
    const Index count = first.n_vertices();
    if (last.rows() != count || frame.rows() != count || before.rows() != count)
        throw InvalidInput("the frames of a morph must have the same number of vertices");
    const Adjacency adjacency(first);
    MorphQuality quality;
    Index n_edges = 0;
    for (Index v = 0; v < count; ++v) {
        for (const Index w : adjacency.neighbors(v)) {
            const double wanted = (1 - time) * (first.vertices.row(v) - first.vertices.row(w)).norm() +
                                  time * (last.row(v) - last.row(w)).norm();
            if (v > w || wanted == 0) continue;
            const double error = std::abs((frame.row(v) - frame.row(w)).norm() / wanted - 1);
            quality.mean_edge_error += error;
            quality.largest_edge_error = std::max(quality.largest_edge_error, error);
            ++n_edges;
        }
    }
    if (n_edges > 0) quality.mean_edge_error /= n_edges;
    const double smaller =
        std::min(std::abs(signed_volume(first)), std::abs(signed_volume({last, first.triangles})));
    if (smaller > 0) quality.volume_ratio = std::abs(signed_volume({frame, first.triangles})) / smaller;
    quality.inverted_triangles =
        static_cast<Index>(inverted_triangles(first.triangles, before, frame).size());
    return quality;
}

}  // namespace counterpart
