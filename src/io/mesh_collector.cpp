// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "io/mesh_collector.hpp"

#include <counterpart/base/errors.hpp>

#include <fmt/format.h>

namespace counterpart::io {

MeshFile MeshCollector::finish() {
    const auto n_triangles = static_cast<std::int64_t>(corners_.size() / 3);
    if (n_triangles > max_count || n_vertices() > max_count)
        throw InvalidInput("the mesh has more than 2147483647 vertices or triangles");
    MeshFile result;
    result.mesh.vertices = Eigen::Map<const Points>(coordinates_.data(), n_vertices(), 3);
    coordinates_ = {};
    result.mesh.triangles = Eigen::Map<const Triangles>(corners_.data(), n_triangles, 3);
    corners_ = {};
    if (n_polygons_ > 0) {
        result.notices.push_back(
            fmt::format("{} with more than three corners cut into triangles ({} triangles in all)",
                        n_polygons_ == 1 ? "1 face" : fmt::format("{} faces", n_polygons_), n_triangles));
    }
    return result;
}

}  // namespace counterpart::io
