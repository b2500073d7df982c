// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace counterpart {

namespace geodesic {
class BatchDijkstra;
class BucketQueue;
class Dijkstra;
}  // namespace geodesic

struct DistanceGraphOptions {
    /// Also link the two vertices opposite to an edge by the straight line through the two unfolded
    /// triangles, where that line crosses the edge (the short-cut edges of Hilaga et al. 2001). Paths are
    /// then 1-2 % longer than exact geodesics on average; about 15 % along plain edges.
    bool shortcuts = true;
};

/// The graph on which distances on a mesh are measured: its vertices, linked along edges and shortcuts, in
/// compressed rows. At a non-manifold edge every pair of its triangles is unfolded. Keeps no reference to the
/// mesh; safe to search on several threads at once. About 150 bytes per vertex. Built in O((V + F) log V).
class DistanceGraph {
  public:
    /// Throws InvalidInput for an invalid mesh, or one so large or small that squared lengths leave the range
    /// of double (coordinates spread over more than 1e150 or less than 1e-150).
    explicit DistanceGraph(MeshView mesh, const DistanceGraphOptions& options = {});

    Index n_vertices() const { return static_cast<Index>(first_.size()) - 1; }
    /// Number of undirected links. A pair may be linked twice; the shorter link counts.
    std::size_t n_links() const { return to_.size() / 2; }

    struct Link {
        Index to = 0;
        double length = 0;
        auto operator<=>(const Link&) const = default;
    };
    /// The links of a vertex, sorted by their far end. O(valence log valence); searches use faster access.
    std::vector<Link> links(Index vertex) const;

  private:
    friend class geodesic::BatchDijkstra;
    friend class geodesic::BucketQueue;
    friend class geodesic::Dijkstra;
    struct UndirectedLink {
        Index a = 0, b = 0;
        double length = 0;
    };
    void fill_rows(const std::vector<UndirectedLink>& links);
    void choose_buckets();

    // Vertices are renumbered along a space-filling curve, so that a search finds its neighborhood in the
    // cache: everything below is in ranks.
    std::vector<Index> rank_of_vertex_, vertex_of_rank_;
    std::vector<Index> first_;  // row r is first_[r] .. first_[r + 1]
    std::vector<Index> to_;
    std::vector<double> length_;
    // How the search's queue is cut: see BucketQueue.
    double inverse_bucket_width_ = 0;
    std::size_t n_buckets_ = 2;
    bool ordered_buckets_ = false;
};

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
