// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/average_distances.hpp"

#include "geodesic/row_blocks.hpp"

namespace counterpart::geodesic {

Vector average_distances(const DistanceGraph& graph, std::span<const Index> bases,
                         const DistanceOptions& options) {
    RunningAverage average(graph.n_vertices());
    for_each_row(graph, bases, options, [&](Eigen::Index, const auto& row) { average.add(row); });
    return average.result();
}

}  // namespace counterpart::geodesic
