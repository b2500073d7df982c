// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/frontiers/components.hpp"

#include "base/hash_mixing.hpp"
#include "match/frontiers/side.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace counterpart::frontiers {
namespace {

std::uint64_t signature_of(MeshView mesh, const Adjacency& adjacency) {
    std::vector<std::uint64_t> color(to_size(mesh.n_vertices()), 0), next(color);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) ++color[to_size(mesh.triangles(t, c))];
    std::uint64_t sum = 0;
    for (int round = 0; round < 3; ++round) {
        sum = 0;
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            std::uint64_t around = 0;
            for (const Index w : adjacency.neighbors(v)) around += mixed(color[to_size(w)]);
            next[to_size(v)] = mixed(color[to_size(v)], around);
            sum += next[to_size(v)];
        }
        std::swap(color, next);
    }
    return mixed(sum);
}

[[noreturn]] void differ(const std::string& what) {
    throw UnsuitableMesh("the connectivity differs: " + what +
                         "; the frontier method needs two meshes of the same connectivity");
}

void require_same(Index ours, Index theirs, const char* what) {
    if (ours != theirs) differ(fmt::format("the source has {} {}, the target {}", ours, what, theirs));
}

std::map<std::size_t, Index> valence_histogram(const Adjacency& adjacency) {
    std::map<std::size_t, Index> histogram;
    for (Index v = 0; v < adjacency.n_vertices(); ++v) ++histogram[adjacency.neighbors(v).size()];
    return histogram;
}

bool before(const ComponentMesh& a, const ComponentMesh& b) {
    if (a.vertices.size() != b.vertices.size()) return a.vertices.size() > b.vertices.size();
    return std::pair(a.signature, a.vertices.front()) < std::pair(b.signature, b.vertices.front());
}

bool alike(const ComponentMesh& a, const ComponentMesh& b) {
    return a.vertices.size() == b.vertices.size() && a.signature == b.signature &&
           a.mesh.n_triangles() == b.mesh.n_triangles();
}

}  // namespace

std::vector<ComponentMesh> split_components(MeshView mesh, const Adjacency& adjacency) {
    const Components components = connected_components(adjacency);
    std::vector<std::vector<Index>> vertices(to_size(components.count)), triangles(to_size(components.count));
    std::vector<Index> number(to_size(mesh.n_vertices()));  // of each vertex within its component
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        auto& mine = vertices[to_size(components.of_vertex[to_size(v)])];
        number[to_size(v)] = static_cast<Index>(mine.size());
        mine.push_back(v);
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        triangles[to_size(components.of_vertex[to_size(mesh.triangles(t, 0))])].push_back(t);

    std::vector<ComponentMesh> result;
    for (std::size_t c = 0; c < vertices.size(); ++c) {
        TriangleMesh part{rows_of(mesh.vertices, vertices[c]),
                          Triangles(static_cast<Eigen::Index>(triangles[c].size()), 3)};
        for (std::size_t t = 0; t < triangles[c].size(); ++t)
            for (int k = 0; k < 3; ++k)
                part.triangles(static_cast<Eigen::Index>(t), k) =
                    number[to_size(mesh.triangles(triangles[c][t], k))];
        Adjacency part_adjacency(part);
        const std::uint64_t signature = signature_of(part, part_adjacency);
        result.push_back({std::move(part), std::move(vertices[c]), std::move(part_adjacency), signature});
    }
    std::sort(result.begin(), result.end(), before);
    return result;
}

std::vector<ComponentGroup> group_components(const std::vector<ComponentMesh>& source,
                                             const std::vector<ComponentMesh>& target) {
    require_same(static_cast<Index>(source.size()), static_cast<Index>(target.size()),
                 "connected components");
    std::vector<ComponentGroup> groups;
    // Both lists have the same order, so that equal components take equal positions.
    for (std::size_t c = 0; c < source.size(); ++c) {
        if (!alike(source[c], target[c]))
            differ(fmt::format(
                "component {} by size has {} vertices, {} edges and {} triangles in the source and "
                "{}, {} and {} in the target, or its connectivity differs",
                c + 1, source[c].vertices.size(), source[c].adjacency.n_edges(), source[c].mesh.n_triangles(),
                target[c].vertices.size(), target[c].adjacency.n_edges(), target[c].mesh.n_triangles()));
        if (c == 0 || !alike(source[c - 1], source[c])) groups.emplace_back();
        groups.back().source.push_back(c);
        groups.back().target.push_back(c);
    }
    return groups;
}

void require_same_counts(MeshView source, const Adjacency& source_adjacency, MeshView target,
                         const Adjacency& target_adjacency) {
    require_same(source.n_vertices(), target.n_vertices(), "vertices");
    require_same(source.n_triangles(), target.n_triangles(), "triangles");
    require_same(source_adjacency.n_edges(), target_adjacency.n_edges(), "edges");
    const auto ours = valence_histogram(source_adjacency);
    auto theirs = valence_histogram(target_adjacency);
    for (const auto& [valence, count] : ours)
        require_same(count, theirs[valence], fmt::format("vertices with {} neighbors", valence).c_str());
}

}  // namespace counterpart::frontiers
