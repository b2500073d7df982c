// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/dijkstra.hpp"

#include <algorithm>

namespace counterpart::geodesic {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

Dijkstra::Dijkstra(const DistanceGraph& graph)
    : graph_(graph), distance_(static_cast<std::size_t>(graph.n_vertices()), infinity), queue_(graph) {}

void Dijkstra::search(std::span<const Index> sources, const Limits& limits) {
    forget();
    grow(sources, limits);
}

void Dijkstra::add_source(Index source) {
    visits_are_all_ = visits_are_all_ && visited_ranks_.empty();
    visited_ranks_.clear();
    grow({&source, 1}, {});
}

void Dijkstra::forget() {
    if (visits_are_all_) {
        for (const std::size_t rank : visited_ranks_) distance_[rank] = infinity;
    } else {
        std::fill(distance_.begin(), distance_.end(), infinity);
    }
    visited_ranks_.clear();
    visits_are_all_ = true;
}

void Dijkstra::grow(std::span<const Index> sources, const Limits& limits) {
    queue_.restart();
    for (const Index source : sources)
        if (distance_[rank_of(source)] > 0) lower(rank_of(source), 0);
    std::vector<Index> open_targets(limits.targets.begin(), limits.targets.end());
    for (; !queue_.empty(); queue_.next_bucket()) {
        queue_.settle_bucket([&](const BucketQueue::Entry& entry) { expand(entry, limits.radius); });
        // Where the search did not get yet, the distance is infinite or lies in a later bucket.
        while (!open_targets.empty()) {
            const double reached = distance(open_targets.back());
            if (reached == infinity || !queue_.has_reached(reached)) break;
            open_targets.pop_back();
        }
        if (!limits.targets.empty() && open_targets.empty()) break;
    }
    // After an early stop: what is still queued was reached, but perhaps not over the shortest path.
    queue_.clear([&](const BucketQueue::Entry& entry) {
        if (entry.distance == distance_[entry.rank]) distance_[entry.rank] = infinity;
    });
}

void Dijkstra::lower(std::size_t rank, double distance) {
    distance_[rank] = distance;
    queue_.push({distance, rank});
}

void Dijkstra::expand(const BucketQueue::Entry& entry, double radius) {
    if (entry.distance > distance_[entry.rank]) return;  // reached over a shorter path since
    visited_ranks_.push_back(entry.rank);
    const auto end = static_cast<std::size_t>(graph_.first_[entry.rank + 1]);
    for (auto i = static_cast<std::size_t>(graph_.first_[entry.rank]); i < end; ++i) {
        const double through = entry.distance + graph_.length_[i];
        const auto to = static_cast<std::size_t>(graph_.to_[i]);
        if (through < distance_[to] && through <= radius) lower(to, through);
    }
}

std::vector<Index> Dijkstra::visited() const {
    std::vector<Index> vertices;
    vertices.reserve(visited_ranks_.size());
    for (const std::size_t rank : visited_ranks_) vertices.push_back(graph_.vertex_of_rank_[rank]);
    return vertices;
}

}  // namespace counterpart::geodesic
