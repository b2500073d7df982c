// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/differences/edits.hpp"

#include "match/isomorphism/dart_map.hpp"
#include "mesh/disjoint_sets.hpp"

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

namespace counterpart::differences {

using isomorphism::to_size;

namespace {

// Vertices of both meshes under one numbering: a matched target vertex has its source vertex's number.
class CommonNames {
  public:
    CommonNames(MeshView source, MeshView target, const std::vector<Index>& map)
        : source_(source), target_(target), name_(to_size(target.n_vertices())) {
        std::iota(name_.begin(), name_.end(), source.n_vertices());
        for (Index v = 0; v < source.n_vertices(); ++v)
            if (map[v] >= 0) name_[to_size(map[v])] = v;
    }
    Index corner(bool in_target, Index triangle, int c) const {
        return in_target ? name_[to_size(target_.triangles(triangle, c))] : source_.triangles(triangle, c);
    }

  private:
    MeshView source_;
    MeshView target_;
    std::vector<Index> name_;
};

struct Item {
    bool in_target;
    Index triangle;
};

// The two vertices on the edge that two triangles share, as numbers of that mesh; {-1, -1} if they do not.
std::pair<Index, Index> shared_edge(MeshView mesh, Index t, Index u) {
    std::vector<Index> shared;
    for (int c = 0; c < 3; ++c)
        for (int d = 0; d < 3; ++d)
            if (mesh.triangles(t, c) == mesh.triangles(u, d)) shared.push_back(mesh.triangles(t, c));
    return shared.size() == 2 ? std::pair(shared[0], shared[1]) : std::pair(Index{-1}, Index{-1});
}

// In increasing order, each once.
std::vector<Index> corners_of(MeshView mesh, const std::vector<Index>& triangles) {
    std::vector<Index> corners;
    corners.reserve(3 * triangles.size());
    for (const Index t : triangles)
        for (int c = 0; c < 3; ++c) corners.push_back(mesh.triangles(t, c));
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::string missing(std::string_view from, MeshView mesh, const std::vector<Index>& triangles,
                    const std::vector<Index>& vertices) {
    if (corners_of(mesh, triangles).size() == vertices.size())
        return fmt::format("the {} lacks a component of {} faces (with vertex {})", from, triangles.size(),
                           vertices[0]);
    if (triangles.size() == 1) {
        const Index t = triangles[0];
        return fmt::format("face {} ({}, {}, {}) is missing in the {}", t, mesh.triangles(t, 0),
                           mesh.triangles(t, 1), mesh.triangles(t, 2), from);
    }
    return fmt::format("{} faces around face {} are missing in the {}", triangles.size(), triangles[0], from);
}

std::string describe(MeshView source, MeshView target, const Edit& edit) {
    const std::size_t n = edit.source_triangles.size(), m = edit.target_triangles.size(),
                      gone = edit.source_vertices.size(), added = edit.target_vertices.size();
    if (m == 0) return missing("target", source, edit.source_triangles, edit.source_vertices);
    if (n == 0) return missing("source", target, edit.target_triangles, edit.target_vertices);
    if (n == 2 && m == 2 && gone == 0 && added == 0) {
        const auto [a, b] = shared_edge(source, edit.source_triangles[0], edit.source_triangles[1]);
        const auto [c, d] = shared_edge(target, edit.target_triangles[0], edit.target_triangles[1]);
        if (a >= 0 && c >= 0)
            return fmt::format("edge {}-{} of the source is flipped: {}-{} in the target", a, b, c, d);
    }
    if (gone == 1 && added == 0 && n == m + 2)
        return fmt::format("vertex {} of the source with its {} faces is replaced by {} faces in the target",
                           edit.source_vertices[0], n, m);
    if (gone == 0 && added == 1 && m == n + 2)
        return fmt::format("vertex {} is added in the target: {} faces of the source became {}",
                           edit.target_vertices[0], n, m);
    if (gone == 0 && added == 0 && n == m)
        return fmt::format(
            "{} faces around face {} of the source are triangulated differently (several flipped edges)", n,
            edit.source_triangles[0]);
    return fmt::format(
        "{} faces and {} vertices around face {} of the source are replaced by {} faces and {} vertices "
        "around face {} of the target",
        n, gone, edit.source_triangles[0], m, added, edit.target_triangles[0]);
}

// Items that share an edge are in one place.
mesh::DisjointSets places_of(const std::vector<Item>& items, const CommonNames& names) {
    struct ItemEdge {
        Index first, second, item;
        auto operator<=>(const ItemEdge&) const = default;
    };
    std::vector<ItemEdge> edges;
    edges.reserve(3 * items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const auto [a, b] =
                std::minmax({names.corner(items[i].in_target, items[i].triangle, c),
                             names.corner(items[i].in_target, items[i].triangle, (c + 1) % 3)});
            edges.push_back({a, b, static_cast<Index>(i)});
        }
    }
    std::sort(edges.begin(), edges.end());
    mesh::DisjointSets places(static_cast<Index>(items.size()));
    for (std::size_t e = 1; e < edges.size(); ++e)
        if (edges[e].first == edges[e - 1].first && edges[e].second == edges[e - 1].second)
            places.join(edges[e].item, edges[e - 1].item);
    return places;
}

// Those corners of the triangles that are among the unmatched vertices, both in increasing order.
std::vector<Index> unmatched_corners(MeshView mesh, const std::vector<Index>& triangles,
                                     const std::vector<Index>& unmatched) {
    const std::vector<Index> corners = corners_of(mesh, triangles);
    std::vector<Index> found;
    for (const Index v : corners)
        if (std::binary_search(unmatched.begin(), unmatched.end(), v)) found.push_back(v);
    return found;
}

}  // namespace

std::vector<Edit> find_edits(MeshView source, MeshView target, const MeshDifferences& differences) {
    const CommonNames names(source, target, differences.target_from_source.image());
    std::vector<Item> items;
    for (const Index t : differences.source_triangles) items.push_back({false, t});
    for (const Index t : differences.target_triangles) items.push_back({true, t});
    mesh::DisjointSets places = places_of(items, names);
    std::map<Index, Edit> by_root;
    for (std::size_t i = 0; i < items.size(); ++i) {
        Edit& edit = by_root[places.root(static_cast<Index>(i))];
        (items[i].in_target ? edit.target_triangles : edit.source_triangles).push_back(items[i].triangle);
    }
    std::vector<Edit> edits;
    for (auto& [root, edit] : by_root) {
        edit.source_vertices = unmatched_corners(source, edit.source_triangles, differences.source_vertices);
        edit.target_vertices = unmatched_corners(target, edit.target_triangles, differences.target_vertices);
        edit.sentence = describe(source, target, edit);
        edits.push_back(std::move(edit));
    }
    return edits;
}

}  // namespace counterpart::differences
