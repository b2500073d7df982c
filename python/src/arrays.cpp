// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"

namespace counterpart::python {

Mesh::Mesh(const PointArray& vertices, const TriangleArray& triangles)
    : copy_{map_of(vertices), map_of(triangles)}, view_(copy_) {
    const nb::gil_scoped_release release;
    require_valid(view());
}

SurfaceMap surface_map_of(const IndexArray& triangle, const PointArray& weights, Index target_triangles) {
    SurfaceMap map;
    map.target_triangles = target_triangles;
    map.image.resize(triangle.size());
    for (std::size_t v = 0; v < map.image.size() && v < weights.shape(0); ++v)
        map.image[v] = {triangle(v), {weights(v, 0), weights(v, 1), weights(v, 2)}};
    require_valid(map, static_cast<Index>(triangle.size()), target_triangles);
    return map;
}

std::tuple<NewVector<Index>, NewMatrix<double>> arrays(const SurfaceMap& map) {
    std::vector<Index> triangle;
    triangle.reserve(map.image.size());
    Points weights(static_cast<Eigen::Index>(map.image.size()), 3);
    for (const SurfacePoint& point : map.image) {
        weights.row(static_cast<Eigen::Index>(triangle.size())) = point.weights.transpose();
        triangle.push_back(point.triangle);
    }
    return {array(std::move(triangle)), matrix_array(std::move(weights))};
}

nb::list arrays(std::vector<VertexMap> maps) {
    nb::list list;
    for (const VertexMap& map : maps) list.append(array(map));
    return list;
}

std::tuple<NewMatrix<double>, NewMatrix<Index>> arrays(TriangleMesh mesh) {
    return {matrix_array(std::move(mesh.vertices)), matrix_array(std::move(mesh.triangles))};
}

}  // namespace counterpart::python
