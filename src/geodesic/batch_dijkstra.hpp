// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "geodesic/bucket_queue.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <limits>
#include <span>
#include <vector>

namespace counterpart::geodesic {

/// Shortest paths from up to eight sources at once: bit for bit those of eight single searches, sooner the
/// closer together the sources lie. One object per thread.
///
/// A vertex waits in the queue at the least of its distances that is not passed on
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
    std::size_t rank_of(Index vertex) const {
        return static_cast<std::size_t>(graph_.rank_of_vertex_[static_cast<std::size_t>(vertex)]);
    }
    void queue(std::size_t rank, double distance);
    void expand(const BucketQueue::Entry& entry);

    const DistanceGraph& graph_;
    std::vector<double> distance_;  // `width` for each rank
    std::vector<double> waits_at_;  // by rank: the least distance that is not passed on yet, or `unreached`
    std::vector<double> lowered_;   // per link of the vertex that is expanded
    BucketQueue queue_;
};

}  // namespace counterpart::geodesic
