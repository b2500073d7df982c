// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <vector>

namespace counterpart::geodesic {

struct Extremity {
    Index vertex = 0;
    double average_distance = 0;  ///< divided by the smallest on the surface
};

struct ExtremityOptions {
    double min_average = 1.2;  ///< average distance over the smallest one, at least 1
    double radius = 0.15;      ///< each is the maximum within this distance; mesh units, positive
    double min_apart = 0;      ///< no more distant one lies within this distance; mesh units, at least 0
    int max_count = 12;        ///< keep the most distant ones; at least 1
};

/// The tips of a surface: local maxima of the average geodesic distance (see average_distances), most distant
/// first. Simpler than critical_points, without its convex hull: every maximum that nothing within the radius
/// exceeds counts. `average_distance`: per vertex, mesh units, not all infinite. Throws InvalidInput for
/// other sizes and options out of range. One short search per maximum.
std::vector<Extremity> extremities(const DistanceGraph& graph, const Vector& average_distance,
                                   const ExtremityOptions& options = {});

}  // namespace counterpart::geodesic
