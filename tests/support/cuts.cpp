// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/cuts.hpp"

#include "base/random.hpp"

#include <utility>
#include <vector>

namespace counterpart::test {

PartOfMesh part_of(MeshView mesh, const std::function<bool(const Eigen::RowVector3d&)>& is_kept) {
    std::vector<Index> number(static_cast<std::size_t>(mesh.n_vertices()), -1), kept, triangles;
    std::vector<char> inside;
    for (Index v = 0; v < mesh.n_vertices(); ++v) inside.push_back(is_kept(mesh.vertices.row(v)) ? 1 : 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const auto corner = [&](int c) { return static_cast<std::size_t>(mesh.triangles(t, c)); };
        if (inside[corner(0)] == 0 || inside[corner(1)] == 0 || inside[corner(2)] == 0) continue;
        triangles.push_back(t);
        for (int c = 0; c < 3; ++c) number[corner(c)] = 0;
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (number[static_cast<std::size_t>(v)] == 0) {
            number[static_cast<std::size_t>(v)] = static_cast<Index>(kept.size());
            kept.push_back(v);
        }
    TriangleMesh part{mesh.vertices(kept, Eigen::all), mesh.triangles(triangles, Eigen::all)};
    part.triangles =
        part.triangles.unaryExpr([&](Index v) { return number[static_cast<std::size_t>(v)]; }).eval();
    return {std::move(part), VertexMap(kept, mesh.n_vertices())};
}

PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset) {
    return part_of(mesh, [&](const Eigen::RowVector3d& x) { return x.dot(normal) > offset; });
}

PartOfMesh with_holes(MeshView mesh, int count, double radius, std::uint64_t seed) {
    Random random(seed);
    Points centers(count, 3);
    for (int i = 0; i < count; ++i)
        centers.row(i) = mesh.vertices.row(
            static_cast<Eigen::Index>(random.below(static_cast<std::uint64_t>(mesh.n_vertices()))));
    return part_of(mesh, [&](const Eigen::RowVector3d& x) {
        return (centers.rowwise() - x).rowwise().norm().minCoeff() > radius;
    });
}

}  // namespace counterpart::test
