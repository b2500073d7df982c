// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <span>

namespace counterpart::geodesic {

/// Mean of the distances from each vertex to those of `bases` that it can reach, mesh units; infinite if it
/// can reach none. Small at the center of the surface, large at its extremities: the integral geodesic
/// distance of Hilaga et al. 2001 when the bases are a uniform sample. One search per base; O(V) memory.
Vector average_distances(const DistanceGraph& graph, std::span<const Index> bases,
                         const DistanceOptions& options = {});

}  // namespace counterpart::geodesic
