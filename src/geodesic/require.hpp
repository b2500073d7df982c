// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/errors.hpp>
#include <counterpart/geodesic/distances.hpp>

#include <span>

#include <fmt/format.h>

namespace counterpart::geodesic {

/// Throws InvalidInput naming the first entry that is not a vertex of the graph.
inline void require_vertices(const DistanceGraph& graph, std::span<const Index> vertices, const char* what) {
    for (const Index v : vertices) {
        if (v < 0 || v >= graph.n_vertices())
            throw InvalidInput(fmt::format("{} {} is not a vertex: vertices run from 0 to {}", what, v,
                                           graph.n_vertices() - 1));
    }
}

}  // namespace counterpart::geodesic
