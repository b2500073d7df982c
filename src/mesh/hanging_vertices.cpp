// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/hanging_vertices.hpp"

#include "mesh/disjoint_sets.hpp"
#include "mesh/tetrahedron_faces.hpp"
#include "numerics/closest_triangle.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <algorithm>

namespace counterpart::mesh {
namespace {

// Relative to the face's size.
constexpr double rounding = 1e-9;

}  // namespace

std::optional<HangingVertex> find_hanging_vertex(const TetrahedralMesh& mesh) {
    std::vector<TetrahedronFace> faces;
    for_each_face_group(mesh, [&](std::span<const TetrahedronFace> group) {
        if (group.size() == 1) faces.push_back(group[0]);
    });
    std::sort(faces.begin(), faces.end(),
              [](const TetrahedronFace& a, const TetrahedronFace& b) { return a.face < b.face; });
    DisjointSets connected(mesh.n_vertices());
    for (Index t = 0; t < mesh.n_tetrahedra(); ++t)
        for (int c = 1; c < 4; ++c) connected.join(mesh.tetrahedra(t, 0), mesh.tetrahedra(t, c));

    std::vector<Index> on_boundary;
    for (const TetrahedronFace& face : faces)
        for (const Index v : corners_of(mesh, face)) on_boundary.push_back(v);
    std::sort(on_boundary.begin(), on_boundary.end());
    on_boundary.erase(std::unique(on_boundary.begin(), on_boundary.end()), on_boundary.end());
    const numerics::NearestNeighbors tree(Points(mesh.vertices(on_boundary, Eigen::all)));

    for (const TetrahedronFace& face : faces) {
        const std::array<Index, 3> corners = corners_of(mesh, face);
        const auto at = [&](std::size_t c) -> Eigen::RowVector3d { return mesh.vertices.row(corners[c]); };
        const Eigen::RowVector3d middle = (at(0) + at(1) + at(2)) / 3;
        const double radius =
            std::max({(at(0) - middle).norm(), (at(1) - middle).norm(), (at(2) - middle).norm()});
        Index hanging = -1;
        for (const auto& near : tree.within(middle, radius)) {
            const Index v = on_boundary[static_cast<std::size_t>(near.index)];
            if (std::find(corners.begin(), corners.end(), v) != corners.end() ||
                connected.root(v) != connected.root(corners[0]))
                continue;
            const numerics::ClosestPoint closest =
                numerics::closest_on_triangle(mesh.vertices.row(v), at(0), at(1), at(2));
            const bool at_corner = closest.weights.maxCoeff() > 1 - rounding;
            if (!at_corner && closest.squared_distance <= rounding * radius * rounding * radius)
                hanging = hanging < 0 ? v : std::min(hanging, v);
        }
        if (hanging >= 0) return HangingVertex{hanging, face.face / 4};
    }
    return std::nullopt;
}

}  // namespace counterpart::mesh
