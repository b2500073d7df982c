// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "geodesic/extremities.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/distances.hpp>

#include <algorithm>
#include <numeric>

namespace counterpart::geodesic {

std::vector<Extremity> extremities(const DistanceGraph& graph, const Vector& average_distance,
                                   const ExtremityOptions& options) {
    if (average_distance.size() != graph.n_vertices() || graph.n_vertices() == 0)
        throw InvalidInput("extremities: one average distance per vertex of the graph is needed");
    if (!(options.min_average >= 1) || !(options.radius > 0) || !(options.min_apart >= 0) ||
        options.max_count < 1)
        throw InvalidInput("extremities: an option is out of range");
    const Vector relative = average_distance / average_distance.minCoeff();
    std::vector<Index> order(static_cast<std::size_t>(relative.size()));
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return relative[a] > relative[b]; });
    std::vector<char> covered(order.size(), 0);
    std::vector<Extremity> found;
    for (const Index v : order) {
        if (!(relative[v] >= options.min_average) ||
            found.size() == static_cast<std::size_t>(options.max_count))
            break;
        if (covered[static_cast<std::size_t>(v)]) continue;
        const Vector distance =
            distances_from(graph, v, {.radius = std::max(options.radius, options.min_apart)});
        bool maximal = true;
        for (Index w = 0; w < distance.size(); ++w) {
            if (distance[w] >= options.radius) continue;
            covered[static_cast<std::size_t>(w)] = 1;
            if (relative[w] > relative[v]) maximal = false;
        }
        for (const Extremity& other : found)  // more distant
            if (distance[other.vertex] < options.min_apart) maximal = false;
        if (maximal) found.push_back({v, relative[v]});
    }
    return found;
}

}  // namespace counterpart::geodesic
