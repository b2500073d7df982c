// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/with_quads.hpp"

#include "match/isomorphism/dart_map.hpp"

namespace counterpart::diagonals {

using isomorphism::to_size;

std::array<Index, 4> around_quad(TrianglesView triangles, Index t, Index u) {
    const auto in_other = [&](Index v) {
        return triangles(u, 0) == v || triangles(u, 1) == v || triangles(u, 2) == v;
    };
    Index tip = 0;
    while (tip < 2 && in_other(triangles(t, tip))) ++tip;
    const Index one = triangles(t, (tip + 1) % 3), other = triangles(t, (tip + 2) % 3);
    Index far = 0;
    while (far < 2 && (triangles(u, far) == one || triangles(u, far) == other)) ++far;
    return {triangles(t, tip), one, triangles(u, far), other};
}

WithQuads with_quads(MeshView mesh, const std::vector<std::array<Index, 2>>& quads) {
    WithQuads result{{mesh.vertices, {}}, {}};
    std::vector<char> is_half(to_size(mesh.n_triangles()), 0);
    for (const auto& [t, u] : quads) is_half[to_size(t)] = is_half[to_size(u)] = 1;
    std::vector<Index> corners;  // of polygons, at each corner of the triangles
    Polygons& polygons = result.mesh.polygons;
    polygons.first = {0};
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (is_half[to_size(t)]) continue;
        const Index first = polygons.first.back();
        result.triangle.push_back(t);
        corners.insert(corners.end(), {first, first + 1, first + 2});
        polygons.first.push_back(first + 3);
    }
    for (const std::array<Index, 2>& quad : quads) {
        const Index t = quad[0], u = quad[1];
        const Index first = polygons.first.back();
        result.triangle.insert(result.triangle.end(), {t, u});
        const std::array<Index, 4> corner = around_quad(mesh.triangles, t, u);
        const auto add = [&](Index triangle, Index tip) {
            for (const Index v : mesh.triangles.row(triangle))
                corners.push_back(first + (v == corner[1] ? 1 : v == corner[3] ? 3 : tip));
        };
        add(t, 0);
        add(u, 2);
        polygons.first.push_back(first + 4);
    }
    result.mesh.triangles = mesh.triangles(result.triangle, Eigen::all);
    polygons.corners =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    return result;
}

}  // namespace counterpart::diagonals
