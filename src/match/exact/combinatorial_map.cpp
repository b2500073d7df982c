// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/exact/combinatorial_map.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <span>

#include <fmt/format.h>

namespace counterpart {
namespace {

// One half-edge in the bucket of its smaller endpoint. Its flag's direction bit says that it runs from the
// larger one.
struct Entry {
    Index other;
    Flag flag;
    bool operator<(const Entry& b) const { return other != b.other ? other < b.other : flag < b.flag; }
};

// Valences are small, where insertion beats everything; a fan of thousands still must not cost their square.
void sort_bucket(std::span<Entry> bucket) {
    if (bucket.size() > 24) {
        std::sort(bucket.begin(), bucket.end());
        return;
    }
    for (std::size_t i = 1; i < bucket.size(); ++i) {
        const Entry entry = bucket[i];
        std::size_t j = i;
        for (; j > 0 && entry < bucket[j - 1]; --j) bucket[j] = bucket[j - 1];
        bucket[j] = entry;
    }
}

// Twins in the mesh's own numbering: half-edges meet in the bucket of their smaller endpoint (a counting
// sort).
std::vector<Flag> find_twins(const TriangleMesh& mesh, CombinatorialMap& map) {
    const auto n_vertices = static_cast<std::size_t>(mesh.n_vertices());
    std::vector<std::uint32_t> end(n_vertices + 2,
                                   0);  // after the scatter, end[v + 1] is the end of bucket v
    const auto for_each_halfedge = [&](const auto& body) {
        for (Index t = 0; t < mesh.n_triangles(); ++t) {
            const std::array<Index, 4> v{mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2),
                                         mesh.triangles(t, 0)};
            for (int c = 0; c < 3; ++c)
                if (v[c] != v[c + 1]) body(v[c], v[c + 1], make_flag(t, c));  // a collapsed edge is a border
        }
    };
    for_each_halfedge([&](Index a, Index b, Flag) { ++end[static_cast<std::size_t>(std::min(a, b)) + 2]; });
    for (std::size_t v = 0; v + 1 < end.size(); ++v) end[v + 1] += end[v];
    std::vector<Entry> entries(end.back());
    for_each_halfedge([&](Index a, Index b, Flag f) {
        entries[end[static_cast<std::size_t>(std::min(a, b)) + 1]++] = {std::max(a, b),
                                                                        f | (a > b ? 1U : 0U)};
    });

    std::vector<Flag> twin(3 * static_cast<std::size_t>(mesh.n_triangles()), no_flag);
    for (std::size_t v = 0; v < n_vertices; ++v) {
        const std::span<Entry> bucket(entries.data() + end[v], entries.data() + end[v + 1]);
        sort_bucket(bucket);
        for (std::size_t i = 0, j = 0; i < bucket.size(); i = j) {
            for (j = i + 1; j < bucket.size() && bucket[j].other == bucket[i].other;) ++j;
            if (j - i == 1) ++map.boundary_edges;
            if (j - i > 2) ++map.nonmanifold_edges;
            if (j - i != 2) continue;
            // Opposite directions are the rule; equal ones mean that one of the two triangles is wound the
            // other way round, and crossing the edge then changes the direction.
            const Flag a = bucket[i].flag, b = bucket[i + 1].flag;
            const Flag same_way = (a & 1U) == (b & 1U) ? 1U : 0U;
            twin[halfedge_of(a)] = (b & ~1U) | same_way;
            twin[halfedge_of(b)] = (a & ~1U) | same_way;
        }
    }
    return twin;
}

// Renumbers along breadth-first traversals. The queue is known some steps ahead, so what a step will touch is
// fetched early: on a shuffled mesh nearly every access misses the caches.
void traverse(const TriangleMesh& mesh, const std::vector<Flag>& twin, CombinatorialMap& map) {
    const auto n = static_cast<std::size_t>(mesh.n_triangles());
    constexpr std::size_t ahead = 8;
    std::vector<Index> local_triangle(n, -1), local_vertex(static_cast<std::size_t>(mesh.n_vertices()), -1);
    std::vector<Index>& order = map.input_triangle;
    order.reserve(n);
    map.twin.resize(3 * n);
    map.corner.resize(3 * n);
    const auto visit = [&](Index t) {
        local_triangle[static_cast<std::size_t>(t)] = static_cast<Index>(order.size());
        order.push_back(t);
        __builtin_prefetch(&twin[3 * static_cast<std::size_t>(t)]);
        __builtin_prefetch(&mesh.triangles(t, 0));
    };
    const auto fetch = [&](std::size_t k) {
        const auto t = static_cast<std::size_t>(order[k]);
        for (std::size_t c = 0; c < 3; ++c) {
            const Flag f = twin[3 * t + c];
            if (f != no_flag) __builtin_prefetch(&local_triangle[static_cast<std::size_t>(f >> 3U)]);
            __builtin_prefetch(
                &local_vertex[static_cast<std::size_t>(mesh.triangles(order[k], static_cast<int>(c)))]);
        }
    };
    std::size_t done = 0;
    for (std::size_t seed = 0; seed < n; ++seed) {
        if (local_triangle[seed] >= 0) continue;
        map.island_begin.push_back(static_cast<Index>(done));
        visit(static_cast<Index>(seed));
        for (; done < order.size(); ++done) {
            if (done + ahead < order.size()) fetch(done + ahead);
            const auto t = static_cast<std::size_t>(order[done]);
            for (std::size_t c = 0; c < 3; ++c) {
                const Flag f = twin[3 * t + c];
                if (f != no_flag && local_triangle[static_cast<std::size_t>(f >> 3U)] < 0)
                    visit(triangle_of(f));
                map.twin[3 * done + c] =
                    f == no_flag
                        ? no_flag
                        : (static_cast<Flag>(local_triangle[static_cast<std::size_t>(f >> 3U)]) << 3U) |
                              (f & 7U);
                const Index v = mesh.triangles(static_cast<Index>(t), static_cast<int>(c));
                Index& local = local_vertex[static_cast<std::size_t>(v)];
                if (local < 0) {
                    local = static_cast<Index>(map.input_vertex.size());
                    map.input_vertex.push_back(v);
                }
                map.corner[3 * done + c] = local;
            }
        }
    }
    map.island_begin.push_back(static_cast<Index>(done));
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (local_vertex[static_cast<std::size_t>(v)] < 0) map.isolated.push_back(v);
}

// Only where some edge is run along twice in one direction.
void orient_islands(CombinatorialMap& map) {
    if (std::all_of(map.twin.begin(), map.twin.end(), [](Flag f) { return f == no_flag || (f & 1U) == 0; }))
        return;
    map.flipped.assign(map.input_triangle.size(), 2);
    map.one_sided.assign(static_cast<std::size_t>(map.n_islands()), 0);
    for (Index island = 0; island < map.n_islands(); ++island) {
        const Index begin = map.island_begin[static_cast<std::size_t>(island)];
        std::vector<Index> queue{begin};
        map.flipped[static_cast<std::size_t>(begin)] = 0;
        std::size_t against = 0;
        for (std::size_t k = 0; k < queue.size(); ++k) {
            const unsigned here = map.flipped[static_cast<std::size_t>(queue[k])];
            against += here;
            for (int c = 0; c < 3; ++c) {
                const Flag f = map.across(make_flag(queue[k], c, here));
                if (f == no_flag) continue;
                const unsigned there = map.flipped[static_cast<std::size_t>(f >> 3U)];
                if (there != 2) {
                    if (there != direction_of(f)) map.one_sided[static_cast<std::size_t>(island)] = 1;
                    continue;
                }
                map.flipped[static_cast<std::size_t>(f >> 3U)] = static_cast<std::uint8_t>(direction_of(f));
                queue.push_back(triangle_of(f));
            }
        }
        if (2 * against > queue.size())
            for (const Index t : queue) map.flipped[static_cast<std::size_t>(t)] ^= 1U;
    }
}

Index count_linked_vertices(const CombinatorialMap& map) {
    std::vector<Index> island_of(map.input_vertex.size(), -1);
    Index linked = 0;
    for (Index i = 0; i < map.n_islands(); ++i) {
        for (std::size_t h = 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i)]);
             h < 3 * static_cast<std::size_t>(map.island_begin[static_cast<std::size_t>(i) + 1]); ++h) {
            Index& seen = island_of[static_cast<std::size_t>(map.corner[h])];
            if (seen >= 0 && seen != i) {
                ++linked;
                seen = -2;  // counted
            } else if (seen == -1) {
                seen = i;
            }
        }
    }
    return linked;
}

}  // namespace

CombinatorialMap make_combinatorial_map(const TriangleMesh& mesh) {
    constexpr Index most = (1 << 28) - 1;
    if (mesh.n_triangles() > most) {
        throw InvalidInput(fmt::format("the mesh has {} triangles; exact matching handles at most {}",
                                       mesh.n_triangles(), most));
    }
    CombinatorialMap map;
    const std::vector<Flag> twin = find_twins(mesh, map);
    traverse(mesh, twin, map);
    orient_islands(map);
    map.linked_vertices = map.n_islands() > 1 ? count_linked_vertices(map) : 0;
    return map;
}

}  // namespace counterpart
