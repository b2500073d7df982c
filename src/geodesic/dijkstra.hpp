// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "geodesic/bucket_queue.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <limits>
#include <span>
#include <vector>

namespace counterpart::geodesic {

/// Shortest paths on one graph, reusable for many searches; one object per thread. Its cost is
/// proportional to what it visits, so searches that stop early are cheap.
class Dijkstra {
  public:
    explicit Dijkstra(const DistanceGraph& graph);

    /// Where a search may stop: past `radius`, and once all `targets` are settled (none given = never).
    struct Limits {
        double radius = std::numeric_limits<double>::infinity();
        std::span<const Index> targets = {};
    };

    /// Forgets everything, then finds the distance from the nearest of `sources`.
    void search(std::span<const Index> sources, const Limits& limits);

    /// Adds a source to an unlimited search; visits only what is nearer to it than to the others.
    void add_source(Index source);

    /// Infinite for vertices not reached.
    double distance(Index vertex) const { return distance_[rank_of(vertex)]; }
    /// Vertices whose distance the last call of search or add_source set; a few may occur twice.
    std::vector<Index> visited() const;

  private:
    std::size_t rank_of(Index vertex) const {
        return static_cast<std::size_t>(graph_.rank_of_vertex_[static_cast<std::size_t>(vertex)]);
    }
    void forget();
    void grow(std::span<const Index> sources, const Limits& limits);
    void lower(std::size_t rank, double distance);
    void expand(const BucketQueue::Entry& entry, double radius);

    const DistanceGraph& graph_;
    std::vector<double> distance_;  // by rank
    std::vector<std::size_t> visited_ranks_;
    bool visits_are_all_ = true;  // every finite distance belongs to one of visited_ranks_
    BucketQueue queue_;
};

}  // namespace counterpart::geodesic
