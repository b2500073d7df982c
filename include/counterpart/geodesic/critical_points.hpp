// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/geodesic/distances.hpp>

#include <vector>

namespace counterpart {

struct CriticalPointOptions {
    Index n_bases = 64;  ///< farthest-point samples for averages and the embedding, at least 4
    /// Least prominence that counts, as a fraction of the component's smallest average distance; at least 0.
    /// Lower values give more, finer points.
    double min_prominence = 0.02;
    int n_threads = 0;  ///< 0 = all; does not change the result
    Progress progress{};
};

struct CriticalPoints {
    std::vector<Index> vertices;  ///< the most prominent first
    /// How far the average distance must fall on the way from each to a greater maximum, as a fraction of the
    /// component's smallest average distance.
    std::vector<double> prominence;
    Vector average_distance;  ///< per vertex, mesh units; infinite in components without a sample
};

/// The tips of a surface (its feature points), after Katz, Leifman and Tal 2005: vertices where the average
/// geodesic distance has a local maximum and which lie on the convex hull of the surface's embedding by
/// multidimensional scaling, in which bent limbs are straight. Neither depends on the pose, apart from the
/// choice of the sample.
///
/// Maxima are ordered by prominence (height above the highest saddle that leads to a higher one), ties by
/// vertex; that of the greatest average distance of each component always counts, whether on the hull or not.
/// "On the hull" means within 2 % of the embedding's extent. Components are treated apart. Cost: n_bases
/// searches. Throws InvalidInput for a graph of another mesh and for options out of range.
CriticalPoints critical_points(MeshView mesh, const DistanceGraph& graph,
                               const CriticalPointOptions& options = {});

}  // namespace counterpart
