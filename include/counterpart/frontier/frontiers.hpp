// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/adjacency.hpp>

#include <span>
#include <vector>

namespace counterpart {

/// The breadth-first frontiers around a source vertex: frontier k is the set of vertices k edges away
/// (Sahillioglu and Yemez, section 4.2). Vertices of other components are in none.
struct Frontiers {
    static constexpr Index unreached = -1;

    std::vector<Index> level;  ///< per vertex: its frontier, or `unreached`
    std::vector<Index> order;  ///< the reached vertices by frontier, and by vertex number within it
    std::vector<Index> first;  ///< frontier k is order[first[k] .. first[k + 1])

    Index count() const { return static_cast<Index>(first.size()) - 1; }
    Index source() const { return order.front(); }
    Index size(Index k) const {
        return first[static_cast<std::size_t>(k) + 1] - first[static_cast<std::size_t>(k)];
    }
    std::span<const Index> operator[](Index k) const {
        return std::span(order).subspan(static_cast<std::size_t>(first[static_cast<std::size_t>(k)]),
                                        static_cast<std::size_t>(size(k)));
    }
};

/// Throws InvalidInput if `source` is not a vertex. O(V + E).
Frontiers bfs_frontiers(const Adjacency& adjacency, Index source);

/// Bands of equal distance instead: frontier k holds the vertices at k * width up to (k + 1) * width of some
/// distance, so that frontiers mean the same on meshes of different connectivity (the paper's future work).
/// `distance`: per vertex, 0 or more, infinite for unreached ones; at least one finite. Frontiers may be
/// empty. Throws InvalidInput otherwise, for a width that is not positive and for more than 1e8 frontiers.
/// O(V).
Frontiers distance_frontiers(const Vector& distance, double width);

/// Number of vertices of frontier 0, 1, 2, ...: the same for two meshes of one connectivity and
/// corresponding sources, and for few other pairs of vertices.
std::vector<Index> frontier_sizes(const Frontiers& frontiers);

struct SequenceMatches {
    std::vector<Index> vertices;  ///< those whose sequence agrees, in the order given
    Index longest_agreement = 0;  ///< over all candidates, the largest number of leading frontiers that agree
};
/// The vertices of `candidates` whose sequence of frontier sizes is `sizes`, or with `prefix` starts with it.
/// Each search stops at the first frontier that differs, so that scanning all vertices of an irregular mesh
/// costs little more than O(V).
SequenceMatches find_frontier_sequence(const Adjacency& adjacency, std::span<const Index> candidates,
                                       std::span<const Index> sizes, bool prefix = false, int n_threads = 0);

/// The connected components ("loops") of each frontier, under edges between its own vertices.
struct FrontierLoops {
    std::vector<Index> of_vertex;   ///< loop of each vertex, -1 if unreached
    std::vector<Index> order;       ///< the reached vertices by loop, and by vertex number within it
    std::vector<Index> first;       ///< loop l is order[first[l] .. first[l + 1])
    std::vector<Index> first_loop;  ///< frontier k has the loops first_loop[k] .. first_loop[k + 1]

    Index count() const { return static_cast<Index>(first.size()) - 1; }
    std::span<const Index> operator[](Index loop) const {
        const auto begin = static_cast<std::size_t>(first[static_cast<std::size_t>(loop)]);
        const auto end = static_cast<std::size_t>(first[static_cast<std::size_t>(loop) + 1]);
        return std::span(order).subspan(begin, end - begin);
    }
};
/// O(V + E). Loops of a frontier are numbered by their smallest vertex.
FrontierLoops frontier_loops(const Adjacency& adjacency, const Frontiers& frontiers);

}  // namespace counterpart
