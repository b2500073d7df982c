// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/diagonals/with_quads.hpp"

#include "match/isomorphism/dart_map.hpp"

namespace counterpart::diagonals {

using isomorphism::to_size;

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
        const auto in_other = [&](Index v) {
            return mesh.triangles(u, 0) == v || mesh.triangles(u, 1) == v || mesh.triangles(u, 2) == v;
        };
        Index tip = 0;  // the corner of t that is not on the diagonal
        while (tip < 2 && in_other(mesh.triangles(t, tip))) ++tip;
        // Around the quad: the tip, one end of the diagonal, the other tip, the other end.
        const Index one = mesh.triangles(t, (tip + 1) % 3), other = mesh.triangles(t, (tip + 2) % 3);
        const std::array<Index, 3> place = {0, 1, 3};
        for (Index c = 0; c < 3; ++c) corners.push_back(first + place[to_size((c - tip + 3) % 3)]);
        for (Index c = 0; c < 3; ++c) {
            const Index v = mesh.triangles(u, c);
            corners.push_back(first + (v == one ? 1 : v == other ? 3 : 2));
        }
        polygons.first.push_back(first + 4);
    }
    result.mesh.triangles = mesh.triangles(result.triangle, Eigen::all);
    polygons.corners =
        Eigen::Map<const Triangles>(corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    return result;
}

}  // namespace counterpart::diagonals
