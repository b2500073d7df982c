// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace counterpart::geodesic {

/// Shortest paths on one graph, reusable for many searches; one object per thread. Its cost is
/// proportional to what it visits, so searches that stop early are cheap.
///
/// The queue is a ring of buckets by distance. The vertices of a bucket are settled together: inside it, a
/// vertex reached again over a shorter path is simply expanded again. What comes out is the least sum over
/// all paths, each path's sum rounded from its source on: the same digits as with any other queue.
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
    struct Entry {
        double distance = 0;
        std::size_t rank = 0;
    };

    std::size_t rank_of(Index vertex) const {
        return static_cast<std::size_t>(graph_.rank_of_vertex_[static_cast<std::size_t>(vertex)]);
    }
    std::uint64_t bucket_of(double distance) const {
        return static_cast<std::uint64_t>(distance * graph_.inverse_bucket_width_);
    }
    std::vector<Entry>& bucket(std::uint64_t number) { return buckets_[number & (buckets_.size() - 1)]; }
    void forget();
    void grow(std::span<const Index> sources, const Limits& limits);
    void lower(std::size_t rank, double distance);
    void settle_current_bucket(double radius);
    void expand(const Entry& entry, double radius);
    void drop_queue();

    const DistanceGraph& graph_;
    std::vector<double> distance_;  // by rank
    std::vector<std::size_t> visited_ranks_;
    bool visits_are_all_ = true;  // every finite distance belongs to one of visited_ranks_
    std::vector<std::vector<Entry>> buckets_;
    std::uint64_t current_ = 0;  // the bucket being settled
    std::size_t n_queued_ = 0;
};

}  // namespace counterpart::geodesic
