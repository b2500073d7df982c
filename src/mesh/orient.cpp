// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/orient.hpp"

#include "mesh/disjoint_sets.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/mesh/measure.hpp>

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

namespace counterpart::mesh {
namespace {

struct EdgeComponent {
    Index n_even = 0, n_odd = 0;  // triangles oriented like the component's first, and opposite to it
    bool open = false, non_orientable = false;
    double volume = 0, area = 0;
};

void flip(TriangleMesh& mesh, Index t) { std::swap(mesh.triangles(t, 1), mesh.triangles(t, 2)); }

std::vector<EdgeComponent> agree_within_components(TriangleMesh& mesh,
                                                   std::vector<Index>& component_of_triangle) {
    mesh::DisjointSets sets(mesh.n_triangles());
    std::vector<EdgeComponent> components(
        static_cast<std::size_t>(mesh.n_triangles()));  // by smallest triangle
    const mesh::EdgeTable edges(mesh);
    std::vector<Index> open, contradicted;
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        if (sides.size() != 2) {
            for (const mesh::EdgeTable::HalfEdge& side : sides) open.push_back(side.triangle);
        } else if (!sets.join(sides[0].triangle, sides[1].triangle, sides[0].forward == sides[1].forward)) {
            contradicted.push_back(sides[0].triangle);
        }
    }
    const auto component = [&](Index t) -> EdgeComponent& {
        return components[static_cast<std::size_t>(sets.root(t))];
    };
    for (const Index t : open) component(t).open = true;
    for (const Index t : contradicted) component(t).non_orientable = true;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        ++(sets.is_odd(t) ? component(t).n_odd : component(t).n_even);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const bool odd_is_less = component(t).n_odd <= component(t).n_even;
        if (sets.is_odd(t) == odd_is_less) flip(mesh, t);
        component_of_triangle.push_back(sets.root(t));
    }
    return components;
}

}  // namespace

OrientResult orient(MeshView mesh) {
    require_valid(mesh);
    OrientResult result;
    result.mesh = mesh.copy();
    std::vector<Index> component_of_triangle;
    std::vector<EdgeComponent> components = agree_within_components(result.mesh, component_of_triangle);
    const Eigen::RowVector3d center = surface_centroid(mesh).transpose();
    const Vector areas = triangle_areas(mesh);
    double open_volume = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        EdgeComponent& component =
            components[static_cast<std::size_t>(component_of_triangle[static_cast<std::size_t>(t)])];
        const auto corner = [&](int c) {
            return Eigen::RowVector3d(result.mesh.vertices.row(result.mesh.triangles(t, c)) - center);
        };
        const double volume = corner(0).dot(corner(1).cross(corner(2))) / 6;
        component.volume += volume;
        component.area += areas[t];
        if (component.open || component.non_orientable) open_volume += volume;
    }
    // Rounding leaves a flat mesh a volume of either sign.
    const double noise = 1e-12 * std::pow(areas.sum(), 1.5);
    double flipped_area = 0;
    for (EdgeComponent& component : components) {
        if (component.non_orientable) ++result.n_one_sided;
        if (!component.non_orientable) result.n_disagreeing += std::min(component.n_even, component.n_odd);
        if (component.open || component.non_orientable) component.volume = open_volume;
        if (component.volume < -noise) flipped_area += component.area;
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (components[static_cast<std::size_t>(component_of_triangle[static_cast<std::size_t>(t)])].volume <
            -noise)
            flip(result.mesh, t);
    result.was_inside_out = flipped_area > areas.sum() / 2;
    return result;
}

}  // namespace counterpart::mesh
