// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/partition.hpp"

#include "base/parallel.hpp"
#include "geodesic/dijkstra.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace counterpart::spectral_match {
namespace {

// 1 at 0, 0 at 1, with slope 0 at both ends: (1 - x)^2 (1 + 2 x).
double bump(double x) { return (1 - x) * (1 - x) * (1 + 2 * x); }

}  // namespace

SparseMatrix partition_of_unity(const DistanceGraph& graph, std::span<const Index> samples,
                                std::span<const Index> nearest, double radius,
                                const ProgressRange& progress) {
    std::vector<std::vector<std::pair<Index, double>>> columns(samples.size());
    parallel_for_with(
        samples.size(), 1, [&] { return geodesic::Dijkstra(graph); },
        [&](geodesic::Dijkstra& dijkstra, std::size_t s) {
            progress.check();
            dijkstra.search(std::array{samples[s]}, {.radius = radius});
            std::vector<Index> reached = dijkstra.visited();
            std::sort(reached.begin(), reached.end());
            reached.erase(std::unique(reached.begin(), reached.end()), reached.end());
            for (const Index v : reached) {
                const double weight = bump(std::min(dijkstra.distance(v) / radius, 1.0));
                if (weight > 0) columns[s].emplace_back(v, weight);
            }
        });
    Vector sum = Vector::Zero(graph.n_vertices());
    for (const auto& column : columns)
        for (const auto& [v, weight] : column) sum[v] += weight;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t s = 0; s < columns.size(); ++s)
        for (const auto& [v, weight] : columns[s])
            entries.emplace_back(v, static_cast<int>(s), weight / sum[v]);
    for (Index v = 0; v < graph.n_vertices(); ++v)
        if (sum[v] == 0) entries.emplace_back(v, std::max(nearest[static_cast<std::size_t>(v)], 0), 1.0);
    SparseMatrix result(graph.n_vertices(), static_cast<Eigen::Index>(samples.size()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

}  // namespace counterpart::spectral_match
