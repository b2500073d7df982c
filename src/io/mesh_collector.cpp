// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/mesh_collector.hpp"

#include "io/left_out.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart::io {

MeshFile MeshCollector::finish() {
    const auto n_corners = static_cast<std::int64_t>(corners_.size());
    if (n_corners > max_count || n_vertices() > max_count)
        throw InvalidInput("the mesh has more than 2147483647 vertices or corners of faces");
    Points points = PointsView(coordinates_.data(), static_cast<Eigen::Index>(n_vertices()), 3);
    std::vector<Index> left_out = place_left_out(points);
    MeshFile result{cut_into_triangles(points, sizes_, corners_), {}};
    result.mesh.left_out = std::move(left_out);
    coordinates_ = {};
    corners_ = sizes_ = {};
    if (n_polygons_ > 0) {
        result.notices.push_back(fmt::format(
            "{} with more than three corners cut into triangles ({} triangles in all)",
            n_polygons_ == 1 ? "1 face" : fmt::format("{} faces", n_polygons_), result.mesh.n_triangles()));
    }
    if (n_large_ > 0) {
        result.notices.push_back(
            fmt::format("faces with more than {} corners are cut as if they were convex ({} of them)",
                        max_ear_corners, n_large_));
    }
    return result;
}

}  // namespace counterpart::io
