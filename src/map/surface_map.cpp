// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/base/errors.hpp>
#include <counterpart/map/surface_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace counterpart {

void require_valid(const SurfaceMap& map, Index source_size, Index target_triangles) {
    if (map.source_size() != source_size) {
        throw InvalidInput(fmt::format("the map has {} entries but the source has {} vertices",
                                       map.source_size(), source_size));
    }
    for (Index v = 0; v < source_size; ++v) {
        const SurfacePoint& point = map[v];
        if (!point.matched()) continue;
        if (point.triangle < 0 || point.triangle >= target_triangles) {
            throw InvalidInput(
                fmt::format("the map takes source vertex {} to triangle {}, but the target has {} triangles",
                            v, point.triangle, target_triangles));
        }
        // Written so that NaN fails too.
        if (!(point.weights.minCoeff() >= -1e-9 && std::abs(point.weights.sum() - 1) <= 1e-6)) {
            throw InvalidInput(fmt::format(
                "the weights of source vertex {} are ({}, {}, {}); they must be at least 0 and sum to 1", v,
                point.weights[0], point.weights[1], point.weights[2]));
        }
    }
}

SurfaceMap surface_map_of(const VertexMap& target_from_source, MeshView target) {
    require_valid(target_from_source, target_from_source.source_size(), target.n_vertices());
    std::vector<SurfacePoint> place(static_cast<std::size_t>(target.n_vertices()));
    for (Index t = target.n_triangles(); t-- > 0;) {
        for (int c = 3; c-- > 0;)
            place[static_cast<std::size_t>(target.triangles(t, c))] = {t, Eigen::Vector3d::Unit(c)};
    }
    SurfaceMap map{{}, target.n_triangles()};
    map.image.reserve(static_cast<std::size_t>(target_from_source.source_size()));
    for (const Index image : target_from_source.image())
        map.image.push_back(image < 0 ? SurfacePoint{} : place[static_cast<std::size_t>(image)]);
    return map;
}

VertexMap nearest_corners(const SurfaceMap& target_from_source, MeshView target) {
    require_valid(target_from_source, target_from_source.source_size(), target.n_triangles());
    std::vector<Index> image;
    image.reserve(target_from_source.image.size());
    for (const SurfacePoint& point : target_from_source.image) {
        Eigen::Index corner = 0;
        point.weights.maxCoeff(&corner);
        image.push_back(point.matched() ? target.triangles(point.triangle, corner) : VertexMap::unmatched);
    }
    return {std::move(image), target.n_vertices()};
}

Matrix transfer_values(const SurfaceMap& target_from_source, MeshView target, const Matrix& values) {
    require_valid(target_from_source, target_from_source.source_size(), target.n_triangles());
    if (values.rows() != target.n_vertices()) {
        throw InvalidInput(fmt::format("{} rows of values were given for {} target vertices", values.rows(),
                                       target.n_vertices()));
    }
    Matrix result(target_from_source.source_size(), values.cols());
    for (Index v = 0; v < target_from_source.source_size(); ++v) {
        const SurfacePoint& point = target_from_source[v];
        if (!point.matched()) {
            result.row(v).setConstant(std::numeric_limits<double>::quiet_NaN());
            continue;
        }
        result.row(v).setZero();
        // Corners of weight 0 are skipped, so that a corner of weight 1 gives its value bit for bit.
        for (int c = 0; c < 3; ++c) {
            if (point.weights[c] != 0)
                result.row(v) += point.weights[c] * values.row(target.triangles(point.triangle, c));
        }
    }
    return result;
}

Points image_positions(const SurfaceMap& target_from_source, MeshView target) {
    return transfer_values(target_from_source, target, target.vertices);
}

Index count_matched(const SurfaceMap& map) {
    return static_cast<Index>(std::count_if(map.image.begin(), map.image.end(),
                                            [](const SurfacePoint& point) { return point.matched(); }));
}

}  // namespace counterpart
