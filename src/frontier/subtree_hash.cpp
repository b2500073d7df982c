// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "frontier/subtree_hash.hpp"

#include "base/hash_mixing.hpp"
#include "base/to_size.hpp"

namespace counterpart::frontier {
namespace {

constexpr std::uint64_t child = 1, sibling = 2;  // roles, so that a child is not taken for a sibling

}  // namespace

std::vector<std::uint64_t> subtree_hashes(MeshView mesh, const Adjacency& adjacency,
                                          const Frontiers& frontiers) {
    std::vector<std::uint32_t> n_triangles(to_size(adjacency.n_vertices()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (int c = 0; c < 3; ++c) ++n_triangles[to_size(mesh.triangles(t, c))];

    // Sums over neighbors do not depend on the order in which they are listed.
    std::vector<std::uint64_t> hash(n_triangles.size(), 0), below;
    for (Index k = frontiers.count() - 1; k >= 0; --k) {
        const auto frontier = frontiers[k];
        below.clear();
        for (const Index v : frontier) {
            std::uint64_t n_parents = 0, n_siblings = 0, n_children = 0, children = 0;
            for (const Index w : adjacency.neighbors(v)) {
                const Index level = frontiers.level[to_size(w)];
                n_parents += level < k ? 1 : 0;
                n_siblings += level == k ? 1 : 0;
                if (level <= k) continue;
                ++n_children;
                children += mixed(hash[to_size(w)], child);
            }
            const std::uint64_t counts =
                n_triangles[to_size(v)] + (n_parents << 16) + (n_siblings << 32) + (n_children << 48);
            below.push_back(mixed(counts, children));
        }
        // Siblings are read from `below` through `hash`, so it is filled first and refined after.
        for (std::size_t i = 0; i < frontier.size(); ++i) hash[to_size(frontier[i])] = below[i];
        for (std::size_t i = 0; i < frontier.size(); ++i) {
            std::uint64_t siblings = 0;
            for (const Index w : adjacency.neighbors(frontier[i]))
                if (frontiers.level[to_size(w)] == k) siblings += mixed(hash[to_size(w)], sibling);
            below[i] = mixed(below[i], siblings);
        }
        for (std::size_t i = 0; i < frontier.size(); ++i) hash[to_size(frontier[i])] = below[i];
    }
    return hash;
}

}  // namespace counterpart::frontier
