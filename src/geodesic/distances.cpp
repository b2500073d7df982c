// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "geodesic/batch_dijkstra.hpp"
#include "geodesic/dijkstra.hpp"
#include "geodesic/require.hpp"

#include <counterpart/geodesic/distances.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <numeric>
#include <thread>

namespace counterpart {
namespace {

// body(search, i) for i in [0, count), threaded. Progress is told between the searches of the calling
// thread, so that it waits for none of the others.
template <class Search, class Body>
void for_each_search(const DistanceGraph& graph, std::size_t count, const DistanceOptions& options,
                     const Body& body) {
    const auto caller = std::this_thread::get_id();
    std::atomic<std::size_t> n_done = 0;
    report_progress(options.progress, 0);
    with_threads(options.n_threads, [&] {
        parallel_for_with(
            count, 1, [&] { return Search(graph); },
            [&](Search& search, std::size_t i) {
                body(search, i);
                const std::size_t done = ++n_done;
                if (options.progress && done < count && std::this_thread::get_id() == caller)
                    report_progress(options.progress, static_cast<double>(done) / static_cast<double>(count));
            });
    });
    report_progress(options.progress, 1);
}

}  // namespace

Vector distances_from(const DistanceGraph& graph, std::span<const Index> sources,
                      const SearchLimits& limits) {
    if (sources.empty()) throw InvalidInput("distances need at least one source vertex");
    geodesic::require_vertices(graph, sources, "source");
    geodesic::require_vertices(graph, limits.targets, "target");
    if (!(limits.radius >= 0))
        throw InvalidInput(fmt::format("the search radius must be at least 0, not {}", limits.radius));
    geodesic::Dijkstra dijkstra(graph);
    dijkstra.search(sources, {limits.radius, limits.targets});
    Vector distance(graph.n_vertices());
    for (Index v = 0; v < graph.n_vertices(); ++v) distance[v] = dijkstra.distance(v);
    return distance;
}

Vector distances_from(const DistanceGraph& graph, Index source, const SearchLimits& limits) {
    return distances_from(graph, std::span(&source, 1), limits);
}

Matrix distance_rows(const DistanceGraph& graph, std::span<const Index> sources,
                     const DistanceOptions& options) {
    geodesic::require_vertices(graph, sources, "source");
    Matrix rows(static_cast<Eigen::Index>(sources.size()), graph.n_vertices());
    using geodesic::BatchDijkstra;
    const std::vector<BatchDijkstra::Batch> batches =
        with_threads(options.n_threads, [&] { return BatchDijkstra::batches(graph, sources); });
    for_each_search<BatchDijkstra>(
        graph, batches.size(), options, [&](BatchDijkstra& dijkstra, std::size_t b) {
            dijkstra.search(batches[b].sources);
            for (std::size_t i = 0; i < batches[b].sources.size(); ++i)
                for (Index v = 0; v < graph.n_vertices(); ++v)
                    rows(static_cast<Eigen::Index>(batches[b].numbers[i]), v) = dijkstra.distance(i, v);
        });
    return rows;
}

Vector pair_distances(const DistanceGraph& graph, std::span<const std::pair<Index, Index>> pairs,
                      const DistanceOptions& options) {
    std::vector<std::size_t> order(pairs.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return std::pair(pairs[i], i) < std::pair(pairs[j], j); });
    std::vector<std::size_t> first_of_group;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto& [from, to] = pairs[order[i]];
        geodesic::require_vertices(graph, std::array{from, to}, "an end of a pair");
        if (i == 0 || from != pairs[order[i - 1]].first) first_of_group.push_back(i);
    }
    first_of_group.push_back(order.size());

    Vector result(static_cast<Eigen::Index>(pairs.size()));
    for_each_search<geodesic::Dijkstra>(
        graph, first_of_group.size() - 1, options, [&](geodesic::Dijkstra& dijkstra, std::size_t group) {
            std::vector<Index> targets;
            for (std::size_t i = first_of_group[group]; i < first_of_group[group + 1]; ++i)
                targets.push_back(pairs[order[i]].second);
            dijkstra.search(std::array{pairs[order[first_of_group[group]]].first}, {.targets = targets});
            for (std::size_t i = first_of_group[group]; i < first_of_group[group + 1]; ++i)
                result[static_cast<Eigen::Index>(order[i])] = dijkstra.distance(pairs[order[i]].second);
        });
    return result;
}

}  // namespace counterpart
