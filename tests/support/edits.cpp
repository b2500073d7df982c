// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "support/edits.hpp"

#include "base/random.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace counterpart::test {
namespace {

// Triangle and corner of each directed edge.
std::map<std::pair<Index, Index>, std::pair<Index, int>> directed_edges(const TriangleMesh& mesh) {
    std::map<std::pair<Index, Index>, std::pair<Index, int>> edges;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) edges[{mesh.triangles(t, c), mesh.triangles(t, (c + 1) % 3)}] = {t, c};
    return edges;
}

std::vector<Index> all(Index count) {
    std::vector<Index> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

}  // namespace

EditedMesh with_flipped_edges(const TriangleMesh& mesh, Index count, std::uint64_t seed) {
    Random random(seed);
    EditedMesh result{mesh, all(mesh.n_vertices()), {}};
    const auto edges = directed_edges(mesh);
    while (static_cast<Index>(result.changed.size()) < 2 * count) {
        const auto t = static_cast<Index>(random.below(static_cast<std::uint64_t>(mesh.n_triangles())));
        const auto c = static_cast<int>(random.below(3));
        const Index a = mesh.triangles(t, c), b = mesh.triangles(t, (c + 1) % 3),
                    x = mesh.triangles(t, (c + 2) % 3);
        const auto twin = edges.find({b, a});
        if (twin == edges.end()) continue;
        const auto [u, d] = twin->second;
        const Index y = mesh.triangles(u, (d + 2) % 3);
        if (x == y || edges.contains({x, y}) || edges.contains({y, x}) || result.changed.contains(t) ||
            result.changed.contains(u))
            continue;
        result.mesh.triangles.row(t) << x, a, y;
        result.mesh.triangles.row(u) << y, b, x;
        result.changed.insert({t, u});
    }
    return result;
}

EditedMesh without_vertex(const TriangleMesh& mesh, std::uint64_t seed) {
    Random random(seed);
    const auto edges = directed_edges(mesh);
    for (;;) {
        const auto v = static_cast<Index>(random.below(static_cast<std::uint64_t>(mesh.n_vertices())));
        // The ring in order: the edge opposite v in each of its triangles.
        std::map<Index, Index> follows;
        std::set<Index> around;
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            for (int c = 0; c < 3; ++c) {
                if (mesh.triangles(t, c) != v) continue;
                follows[mesh.triangles(t, (c + 1) % 3)] = mesh.triangles(t, (c + 2) % 3);
                around.insert(t);
            }
        }
        if (follows.size() < 4 || follows.size() != around.size()) continue;
        std::vector<Index> ring{follows.begin()->first};
        while (follows.contains(ring.back()) && ring.size() < follows.size())
            ring.push_back(follows[ring.back()]);
        if (ring.size() != follows.size() || follows[ring.back()] != ring[0]) continue;
        bool free = true;  // the fan's new edges must not exist
        for (std::size_t i = 2; i + 1 < ring.size(); ++i)
            free = free && !edges.contains({ring[0], ring[i]}) && !edges.contains({ring[i], ring[0]});
        if (!free) continue;

        EditedMesh result{{}, all(mesh.n_vertices()), around};
        for (std::size_t w = 0; w < result.edited_from_original.size(); ++w)
            if (static_cast<Index>(w) > v) --result.edited_from_original[w];
        result.edited_from_original[static_cast<std::size_t>(v)] = -1;
        result.mesh.vertices.resize(mesh.n_vertices() - 1, 3);
        for (Index w = 0; w < mesh.n_vertices(); ++w)
            if (w != v)
                result.mesh.vertices.row(result.edited_from_original[static_cast<std::size_t>(w)]) =
                    mesh.vertices.row(w);
        result.mesh.triangles.resize(mesh.n_triangles() - 2, 3);
        Index next = 0;
        const auto add = [&](Index a, Index b, Index c) {
            const auto& to = result.edited_from_original;
            result.mesh.triangles.row(next++) << to[static_cast<std::size_t>(a)],
                to[static_cast<std::size_t>(b)], to[static_cast<std::size_t>(c)];
        };
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            if (!around.contains(t)) add(mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2));
        for (std::size_t i = 1; i + 1 < ring.size(); ++i) add(ring[0], ring[i], ring[i + 1]);
        return result;
    }
}

EditedMesh with_missing_triangles(const TriangleMesh& mesh, double fraction, std::uint64_t seed) {
    Random random(seed);
    std::vector<Index> order = all(mesh.n_triangles());
    random.shuffle(order);
    const auto n_gone = static_cast<std::size_t>(fraction * mesh.n_triangles());
    EditedMesh result{
        mesh, all(mesh.n_vertices()), {order.begin(), order.begin() + static_cast<long>(n_gone)}};
    Index next = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (!result.changed.contains(t)) result.mesh.triangles.row(next++) = mesh.triangles.row(t);
    result.mesh.triangles.conservativeResize(next, 3);
    return result;
}

EditedMesh without_last_island(const TriangleMesh& mesh, Index first) {
    EditedMesh result{mesh, all(mesh.n_vertices()), {}};
    std::fill(result.edited_from_original.begin() + first, result.edited_from_original.end(), -1);
    Index kept = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (mesh.triangles(t, 0) >= first)
            result.changed.insert(t);
        else
            result.mesh.triangles.row(kept++) = mesh.triangles.row(t);
    }
    result.mesh.triangles.conservativeResize(kept, 3);
    result.mesh.vertices.conservativeResize(first, 3);
    return result;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh both{Points(a.n_vertices() + b.n_vertices(), 3),
                      Triangles(a.n_triangles() + b.n_triangles(), 3)};
    both.vertices << a.vertices, b.vertices;
    both.triangles << a.triangles, (b.triangles.array() + a.n_vertices()).matrix();
    return both;
}

}  // namespace counterpart::test
