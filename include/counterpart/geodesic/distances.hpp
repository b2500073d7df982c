// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/geodesic/distance_graph.hpp>

#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace counterpart {

/// When a search may stop.
struct SearchLimits {
    /// Vertices farther than this are left infinite. Mesh units.
    double radius = std::numeric_limits<double>::infinity();
    /// If not empty: stop once all of these are reached. Vertices not reached by then are left infinite.
    std::vector<Index> targets{};
};

/// For computations from many sources.
struct DistanceOptions {
    int n_threads = 0;  ///< 0 = all; does not change the result
    Progress progress{};
};

/// Length of the shortest path on the graph from the nearest of `sources` to each vertex, in mesh units;
/// infinite where no path leads. O(V) in practice: about 0.1 s per million vertices. Throws InvalidInput for
/// no sources, a source or target that is not a vertex, or a negative radius.
Vector distances_from(const DistanceGraph& graph, std::span<const Index> sources,
                      const SearchLimits& limits = {});
Vector distances_from(const DistanceGraph& graph, Index source, const SearchLimits& limits = {});

/// Row i holds the distances from sources[i] to all vertices: sources x V, 8 bytes each.
Matrix distance_rows(const DistanceGraph& graph, std::span<const Index> sources,
                     const DistanceOptions& options = {});

/// The distance of each pair (from, to); infinite between components. Searches stop as early as possible, so
/// pairs of near vertices cost next to nothing; pairs with the same first vertex share a search. O(pairs)
/// memory.
Vector pair_distances(const DistanceGraph& graph, std::span<const std::pair<Index, Index>> pairs,
                      const DistanceOptions& options = {});

}  // namespace counterpart
