// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/adjacency.hpp>

#include <span>
#include <string>
#include <vector>

namespace counterpart {

/// How the pair of seed vertices was found.
enum class SeedTest {
    given,            ///< given by the caller
    critical_both,    ///< a critical point of each mesh, with equal frontier sizes and subtrees
    critical_source,  ///< a critical point of the source, and the target vertex with its frontier sizes
    eccentric,        ///< no critical point is unique, but the vertex of the largest sum of hop counts is
    ambiguous,        ///< no vertex is unique: several target vertices qualify and positions decide
    none,             ///< no target vertex has the frontier sizes: the connectivity differs
};
std::string to_string(SeedTest test);

/// The breadth-first frontiers around a source vertex: frontier k is the set of vertices k edges away
/// (Sahillioglu and Yemez, section 4.2). Vertices of other components are in no frontier.
struct Frontiers {
    static constexpr Index unreached = -1;

    std::vector<Index> level;  ///< per vertex: its frontier, or `unreached`
    std::vector<Index> order;  ///< the reached vertices by frontier, and by vertex within it
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

/// Bands of a given width instead of breadth-first levels: frontier k holds the vertices whose distance is in
/// [k * width, (k + 1) * width), so that frontiers are comparable between meshes of different connectivity
/// (the paper's future work). `distance`: per vertex, at least 0, infinite for unreached ones; at least one
/// finite. Frontiers may be empty. Throws InvalidInput otherwise, for a width that is not positive and for
/// more than 1e8 frontiers. O(V).
Frontiers distance_frontiers(const Vector& distance, double width);

/// Number of vertices of frontier 0, 1, 2, ...: equal for corresponding source vertices of two meshes of the
/// same connectivity, and for few other pairs of vertices.
std::vector<Index> frontier_sizes(const Frontiers& frontiers);

struct SequenceMatches {
    std::vector<Index> vertices;  ///< candidates with the given sizes, in the given order
    Index longest_agreement = 0;  ///< most leading frontiers on which any candidate agrees
};
/// The vertices of `candidates` whose sequence of frontier sizes is `sizes`, or with `prefix` starts with it.
/// Each search stops at the first frontier that differs, so that scanning all vertices of an irregular mesh
/// costs little more than O(V).
SequenceMatches find_frontier_sequence(const Adjacency& adjacency, std::span<const Index> candidates,
                                       std::span<const Index> sizes, bool prefix = false, int n_threads = 0,
                                       const Progress& progress = {});

/// The connected components ("loops") of each frontier, under edges between its own vertices.
struct FrontierLoops {
    std::vector<Index> of_vertex;   ///< loop of each vertex, -1 if unreached
    std::vector<Index> order;       ///< the reached vertices by loop, and by vertex within it
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
