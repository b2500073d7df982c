// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/polygons.hpp"

#include "base/random.hpp"

#include <cmath>
#include <map>
#include <utility>

namespace counterpart::test {

void PolygonList::add(const std::vector<Index>& polygon) {
    sizes.push_back(static_cast<Index>(polygon.size()));
    corners.insert(corners.end(), polygon.begin(), polygon.end());
}

TriangleMesh PolygonList::cut() const {
    Points points(static_cast<Index>(vertices.size()), 3);
    for (std::size_t v = 0; v < vertices.size(); ++v) points.row(static_cast<Index>(v)) = vertices[v];
    return cut_into_triangles(points, sizes, corners);
}

PolygonList polygons_of(MeshView mesh) {
    PolygonList list;
    for (Index v = 0; v < mesh.n_vertices(); ++v) list.vertices.emplace_back(mesh.vertices.row(v));
    if (mesh.polygons == nullptr) {
        list.sizes.assign(static_cast<std::size_t>(mesh.n_triangles()), 3);
        list.corners.assign(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
        return list;
    }
    for (Index p = 0; p < mesh.polygons->count(); ++p) list.sizes.push_back(mesh.polygons->size(p));
    for (const Index corner : mesh.polygons->triangle_corners())
        list.corners.push_back(mesh.triangles.data()[corner]);
    return list;
}

TriangleMesh cut_at_random(const TriangleMesh& quads, std::uint64_t seed) {
    Random random(seed);
    const PolygonList list = polygons_of(quads);
    TriangleMesh mesh{quads.vertices, Triangles(quads.n_triangles(), 3)};
    const Index* v = list.corners.data();
    Eigen::Index t = 0;
    for (const Index size : list.sizes) {
        const auto k = static_cast<std::size_t>(size == 4 ? random.below(2) : 0);
        mesh.triangles.row(t++) << v[k], v[k + 1], v[k + 2];
        if (size == 4) mesh.triangles.row(t++) << v[k], v[k + 2], v[(k + 3) % 4];
        v += size;
    }
    return mesh;
}

TriangleMesh make_quads(MeshView mesh) {
    PolygonList list;
    for (Index v = 0; v < mesh.n_vertices(); ++v) list.vertices.emplace_back(mesh.vertices.row(v));
    std::map<std::pair<Index, Index>, Index> middles;
    const auto add_middle = [&](Index a, Index b) {
        const auto [known, is_new] =
            middles.try_emplace(std::minmax({a, b}), static_cast<Index>(list.vertices.size()));
        if (is_new) list.vertices.emplace_back((mesh.vertices.row(a) + mesh.vertices.row(b)) / 2);
        return known->second;
    };
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const Index a = mesh.triangles(t, 0), b = mesh.triangles(t, 1), c = mesh.triangles(t, 2);
        const Index ab = add_middle(a, b), bc = add_middle(b, c), ca = add_middle(c, a);
        const auto center = static_cast<Index>(list.vertices.size());
        list.vertices.emplace_back((mesh.vertices.row(a) + mesh.vertices.row(b) + mesh.vertices.row(c)) / 3);
        list.add({a, ab, center, ca});
        list.add({b, bc, center, ab});
        list.add({c, ca, center, bc});
    }
    return list.cut();
}

TriangleMesh make_polygon_soup(Index max_corners, std::uint64_t seed) {
    Random random(seed);
    PolygonList list;
    constexpr double two_pi = 6.283185307179586;
    const auto add_ring = [&](Index n, double x, double y, double inner, double outer, bool clockwise) {
        std::vector<Index> ring;
        for (Index k = 0; k < n; ++k) {
            const double angle = (clockwise ? -two_pi : two_pi) * k / n,
                         radius = random.uniform(inner, outer);
            ring.push_back(static_cast<Index>(list.vertices.size()));
            list.vertices.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle), 0);
        }
        return ring;
    };
    for (Index n = 3; n <= max_corners; ++n) {
        list.add(add_ring(n, 3 * n, 0, 0.2, 1, false));
        if (n < 8) continue;
        // Outside and back along the bridge: n corners in all.
        std::vector<Index> outer = add_ring(n / 2 - 1, 3 * n, 3, 1, 1.2, false),
                           inner = add_ring(n - n / 2 - 1, 3 * n, 3, 0.2, 0.4, true);
        outer.push_back(outer.front());
        inner.push_back(inner.front());
        outer.insert(outer.end(), inner.begin(), inner.end());
        list.add(outer);
    }
    return list.cut();
}

}  // namespace counterpart::test
