// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace counterpart::geodesic {

/// Shortest paths from up to eight sources at once: bit for bit those of eight single searches, sooner the
/// closer together the sources lie. One object per thread.
///
/// The queue is that of Dijkstra. A vertex waits in it at the least of its distances that is not passed on
/// yet; when it is expanded, all eight are. Between the sources that is once for each front that arrives,
/// elsewhere on bodies twice or three times.
class BatchDijkstra {
  public:
    static constexpr std::size_t width = 8;  ///< sources at once
    static constexpr double unreached = std::numeric_limits<double>::infinity();

    explicit BatchDijkstra(const DistanceGraph& graph);

    struct Batch {
        std::vector<Index> sources;        ///< at most `width`
        std::vector<std::size_t> numbers;  ///< of these among all sources
    };
    /// Sources in batches that lie close together; smaller ones where that occupies more threads. To be
    /// called with the threads that will search.
    static std::vector<Batch> batches(const DistanceGraph& graph, std::span<const Index> sources);

    /// Forgets everything, then finds the distances from each of at most `width` sources.
    void search(std::span<const Index> sources);

    /// From source `i`; `unreached` where no path leads.
    double distance(std::size_t i, Index vertex) const { return distance_[width * rank_of(vertex) + i]; }

  private:
    struct Entry {
        double distance = 0;
        std::size_t rank = 0;
    };
    static bool farther(const Entry& a, const Entry& b) { return a.distance > b.distance; }

    std::size_t rank_of(Index vertex) const {
        return static_cast<std::size_t>(graph_.rank_of_vertex_[static_cast<std::size_t>(vertex)]);
    }
    void queue(std::size_t rank, double distance);
    void settle_current_bucket();
    void expand(const Entry& entry);

    const DistanceGraph& graph_;
    std::vector<double> distance_;  // `width` for each rank
    std::vector<double> waits_at_;  // by rank: the least distance that is not passed on yet, or `unreached`
    std::vector<double> lowered_;   // per link of the vertex that is expanded
    std::vector<std::vector<Entry>> buckets_;
    std::uint64_t current_ = 0;
    std::size_t n_queued_ = 0;
};

}  // namespace counterpart::geodesic
