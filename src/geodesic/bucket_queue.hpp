// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace counterpart::geodesic {

/// What waits to be expanded in a search for shortest paths: a ring of buckets by distance (R. B. Dial,
/// "Algorithm 360: Shortest-path forest with topological ordering", 1969). The entries of a bucket are
/// expanded together; what is reached again over a shorter path in it is simply expanded again. What comes
/// out is the least sum over all paths, each path's sum rounded from its source on: the same digits as with
/// any other queue.
class BucketQueue {
  public:
    struct Entry {
        double distance = 0;
        std::size_t rank = 0;
    };

    explicit BucketQueue(const DistanceGraph& graph)
        : inverse_width_(graph.inverse_bucket_width_),
          ordered_(graph.ordered_buckets_),
          buckets_(graph.n_buckets_) {}

    bool empty() const { return n_entries_ == 0; }
    /// Of an empty queue: the next distance may be 0.
    void restart() { current_ = 0; }

    /// Whether all that is at least as near as `distance` has been expanded or is in the current bucket.
    bool has_reached(double distance) const { return bucket_of(distance) <= current_; }

    /// The distance is at least that of the entry being expanded. One beyond the ring waits in the last
    /// bucket: what comes out early is expanded once more than it had to be.
    void push(const Entry& entry) {
        const std::uint64_t number = std::min(bucket_of(entry.distance), current_ + buckets_.size() - 1);
        std::vector<Entry>& entries = bucket(number);
        entries.push_back(entry);
        if (ordered_ && number == current_) std::push_heap(entries.begin(), entries.end(), farther);
        ++n_entries_;
    }

    /// Calls expand(entry), which may push, for all of the current bucket.
    template <class Expand>
    void settle_bucket(const Expand& expand) {
        std::vector<Entry>& entries = bucket(current_);
        if (ordered_) {
            std::make_heap(entries.begin(), entries.end(), farther);
            while (!entries.empty()) {
                std::pop_heap(entries.begin(), entries.end(), farther);
                const Entry nearest = entries.back();
                entries.pop_back();
                --n_entries_;
                expand(nearest);
            }
            return;
        }
        for (std::size_t i = 0; i < entries.size(); ++i) expand(Entry(entries[i]));  // may append
        n_entries_ -= entries.size();
        entries.clear();
    }
    void next_bucket() { ++current_; }

    /// Empties the queue, and calls drop(entry) for all that was left.
    template <class Drop>
    void clear(const Drop& drop) {
        for (; !empty(); next_bucket()) {
            std::vector<Entry>& entries = bucket(current_);
            for (const Entry& entry : entries) drop(entry);
            n_entries_ -= entries.size();
            entries.clear();
        }
    }

  private:
    static bool farther(const Entry& a, const Entry& b) { return a.distance > b.distance; }
    std::uint64_t bucket_of(double distance) const {
        return static_cast<std::uint64_t>(distance * inverse_width_);
    }
    std::vector<Entry>& bucket(std::uint64_t number) { return buckets_[number & (buckets_.size() - 1)]; }

    double inverse_width_;
    bool ordered_;                             // each bucket is kept as a heap
    std::vector<std::vector<Entry>> buckets_;  // as many as a power of 2
    std::uint64_t current_ = 0;
    std::size_t n_entries_ = 0;
};

}  // namespace counterpart::geodesic
