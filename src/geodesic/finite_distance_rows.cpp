// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/finite_distance_rows.hpp"

#include "base/parallel.hpp"
#include "geodesic/batch_dijkstra.hpp"

#include <algorithm>
#include <atomic>

namespace counterpart::geodesic {

Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> finite_distance_rows(
    const DistanceGraph& graph, std::span<const Index> sources, float unreachable,
    const ProgressRange& progress) {
    Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(
        static_cast<Eigen::Index>(sources.size()), graph.n_vertices());
    const std::vector<BatchDijkstra::Batch> batches = BatchDijkstra::batches(graph, sources);
    std::atomic<std::size_t> n_done = 0;
    parallel_for_with(
        batches.size(), 1, [&] { return BatchDijkstra(graph); },
        [&](BatchDijkstra& dijkstra, std::size_t b) {
            progress.check();
            dijkstra.search(batches[b].sources);
            for (std::size_t i = 0; i < batches[b].sources.size(); ++i) {
                const auto row = static_cast<Eigen::Index>(batches[b].numbers[i]);
                for (Index v = 0; v < graph.n_vertices(); ++v)
                    rows(row, v) = std::min(static_cast<float>(dijkstra.distance(i, v)), unreachable);
            }
            progress.reach(static_cast<double>(++n_done) / static_cast<double>(batches.size()));
        });
    return rows;
}

}  // namespace counterpart::geodesic
