// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/batch_dijkstra.hpp"

#include "base/parallel.hpp"
#include "numerics/simd.hpp"
#include "numerics/vector_lanes.hpp"

#include <algorithm>
#include <numeric>

namespace counterpart::geodesic {
namespace {

constexpr double unreached = BatchDijkstra::unreached;

// The links of one vertex.
struct Links {
    std::size_t n = 0;
    const Index* to = nullptr;
    const double* length = nullptr;
};

// Passes the distances at a vertex on to its neighbors. lowered[i]: the least one that became less at the end
// of link i, or `unreached`.
template <int lanes>
[[gnu::always_inline]] inline void pass_on(const double* from, const Links& links, double* distance,
                                           double* lowered) {
    using Doubles = typename numerics::Simd<lanes>::Doubles;
    using DoublesAnywhere = typename numerics::Simd<lanes>::DoublesAnywhere;
    constexpr std::size_t n_vectors = BatchDijkstra::width / (lanes / 2);
    Doubles start[n_vectors];
    for (std::size_t k = 0; k < n_vectors; ++k)
        start[k] = *reinterpret_cast<const DoublesAnywhere*>(from + k * (lanes / 2));
    for (std::size_t i = 0; i < links.n; ++i) {
        double* const end = distance + BatchDijkstra::width * static_cast<std::size_t>(links.to[i]);
        Doubles least = Doubles{} + unreached;
        for (std::size_t k = 0; k < n_vectors; ++k) {
            const Doubles through = start[k] + links.length[i];
            DoublesAnywhere& there = *reinterpret_cast<DoublesAnywhere*>(end + k * (lanes / 2));
            const Doubles gained = through < there ? through : Doubles{} + unreached;
            least = gained < least ? gained : least;
            there = through < there ? through : there;
        }
        double first = least[0];
        for (int k = 1; k < lanes / 2; ++k) first = least[k] < first ? least[k] : first;
        lowered[i] = first;
    }
}

void pass_on_4(const double* from, const Links& links, double* distance, double* lowered) {
    pass_on<4>(from, links, distance, lowered);
}
#ifdef COUNTERPART_WIDE_VECTORS
[[gnu::target("avx2")]] void pass_on_8(const double* from, const Links& links, double* distance,
                                       double* lowered) {
    pass_on<8>(from, links, distance, lowered);
}
[[gnu::target("avx512f")]] void pass_on_16(const double* from, const Links& links, double* distance,
                                           double* lowered) {
    pass_on<16>(from, links, distance, lowered);
}
void pass_on_all(const double* from, const Links& links, double* distance, double* lowered) {
    if (numerics::vector_lanes() == 16) return pass_on_16(from, links, distance, lowered);
    if (numerics::vector_lanes() == 8) return pass_on_8(from, links, distance, lowered);
    pass_on_4(from, links, distance, lowered);
}
#else
void pass_on_all(const double* from, const Links& links, double* distance, double* lowered) {
    pass_on_4(from, links, distance, lowered);
}
#endif

}  // namespace

BatchDijkstra::BatchDijkstra(const DistanceGraph& graph)
    : graph_(graph),
      distance_(width * static_cast<std::size_t>(graph.n_vertices()), unreached),
      waits_at_(static_cast<std::size_t>(graph.n_vertices()), unreached),
      queue_(graph) {
    Index most_links = 0;
    for (std::size_t r = 0; r + 1 < graph.first_.size(); ++r)
        most_links = std::max(most_links, graph.first_[r + 1] - graph.first_[r]);
    lowered_.resize(static_cast<std::size_t>(most_links));
}

std::vector<BatchDijkstra::Batch> BatchDijkstra::batches(const DistanceGraph& graph,
                                                         std::span<const Index> sources) {
    std::vector<std::size_t> order(sources.size());
    std::iota(order.begin(), order.end(), 0);
    const auto rank = [&](std::size_t i) {
        return graph.rank_of_vertex_[static_cast<std::size_t>(sources[i])];
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return rank(i) < rank(j); });
    const std::size_t size =
        std::clamp(sources.size() / static_cast<std::size_t>(threads::n_allowed()), std::size_t{1}, width);
    std::vector<Batch> result;
    for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % size == 0) result.emplace_back();
        result.back().sources.push_back(sources[order[i]]);
        result.back().numbers.push_back(order[i]);
    }
    return result;
}

void BatchDijkstra::search(std::span<const Index> sources) {
    std::fill(distance_.begin(), distance_.end(), unreached);
    queue_.restart();
    for (std::size_t i = 0; i < sources.size(); ++i) {
        distance_[width * rank_of(sources[i]) + i] = 0;
        queue(rank_of(sources[i]), 0);
    }
    for (; !queue_.empty(); queue_.next_bucket())
        queue_.settle_bucket([&](const BucketQueue::Entry& entry) { expand(entry); });
}

// A distance that came along with a smaller one may come out of the queue early. In whatever order vertices
// are expanded, they come to the same distances.
void BatchDijkstra::queue(std::size_t rank, double distance) {
    if (waits_at_[rank] <= distance) return;
    waits_at_[rank] = distance;
    queue_.push({distance, rank});
}

void BatchDijkstra::expand(const BucketQueue::Entry& entry) {
    if (entry.distance != waits_at_[entry.rank]) return;  // passed on before, or waits elsewhere
    waits_at_[entry.rank] = unreached;
    const auto first = static_cast<std::size_t>(graph_.first_[entry.rank]);
    const Links links{static_cast<std::size_t>(graph_.first_[entry.rank + 1]) - first,
                      graph_.to_.data() + first, graph_.length_.data() + first};
    pass_on_all(distance_.data() + width * entry.rank, links, distance_.data(), lowered_.data());
    for (std::size_t i = 0; i < links.n; ++i)
        if (lowered_[i] < unreached) queue(static_cast<std::size_t>(links.to[i]), lowered_[i]);
}

}  // namespace counterpart::geodesic
