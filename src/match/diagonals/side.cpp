// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/side.hpp"

#include <numeric>

#include <Eigen/Geometry>

namespace counterpart::diagonals {

using namespace isomorphism;

Side::Side(MeshView mesh_of_side) : mesh(mesh_of_side), map(make_dart_map(mesh_of_side)) {
    double sum = 0;
    for (Index t = 0; t < map.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c)
            sum += (at(map.origin(make_dart(t, c))) - at(map.origin(next(make_dart(t, c))))).norm();
    scale = sum > 0 ? sum / (3.0 * map.n_triangles()) : 1;
    corner_begin.assign(to_size(map.n_vertices()) + 1, 0);
    for (const Index v : map.corner) ++corner_begin[to_size(v) + 1];
    std::partial_sum(corner_begin.begin(), corner_begin.end(), corner_begin.begin());
    corners.resize(map.corner.size());
    std::vector<std::size_t> place(corner_begin.begin(), corner_begin.end() - 1);
    for (Index t = 0; t < map.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) corners[place[to_size(map.origin(make_dart(t, c)))]++] = make_dart(t, c);
}

Eigen::RowVector3d Side::normal(Index t) const {
    const Dart f = make_dart(t, 0);
    const Eigen::RowVector3d a = at(map.origin(f)), b = at(map.origin(next(f))), c = at(map.apex(f));
    return (b - a).cross(c - a).stableNormalized();
}

void Side::find_diagonals(bool by_shape, Quads quads) {
    if (mesh.polygons == nullptr && !by_shape) return;
    std::vector<Index> polygon;  // of each triangle of the mesh
    if (mesh.polygons != nullptr)
        for (Index p = 0; p < mesh.polygons->count(); ++p)
            polygon.insert(polygon.end(), to_size(mesh.polygons->size(p) - 2), p);
    may_cut.resize(map.corner.size());
    for (Index t = 0; t < map.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Dart f = make_dart(t, c);
            Cut& cut = may_cut[halfedge_of(f)];
            if (mesh.polygons != nullptr)
                cut = is_inside_polygon(f, polygon) ? Cut::likely : Cut::none;
            else if (cuts_convex_quad(f))
                cut = Cut::likely;
            else
                cut = quads == Quads::any && map.across(f) != no_dart ? Cut::unlikely : Cut::none;
        }
}

bool Side::is_inside_polygon(Dart f, const std::vector<Index>& polygon) const {
    const Dart other = map.across(f);
    const auto polygon_of = [&](Dart g) { return polygon[to_size(map.input_triangle[to_size(g >> 3U)])]; };
    return other != no_dart && polygon_of(f) == polygon_of(other);
}

// The halves along the other diagonal must not be turned over either.
bool Side::cuts_convex_quad(Dart f) const {
    const Dart other = map.across(f);
    if (other == no_dart) return false;
    const Eigen::RowVector3d u = at(map.origin(f)), v = at(map.origin(next(f))), w = at(map.apex(f)),
                             p = at(map.apex(other));
    const auto area = [](const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
                         const Eigen::RowVector3d& c) -> Eigen::RowVector3d { return (b - a).cross(c - a); };
    const Eigen::RowVector3d here = area(u, v, w), there = area(v, u, p), normal = here + there;
    constexpr double cos_bend = 0.5;
    return here.dot(there) >= cos_bend * here.norm() * there.norm() && area(u, p, w).dot(normal) >= 0 &&
           area(p, v, w).dot(normal) >= 0;
}

}  // namespace counterpart::diagonals
