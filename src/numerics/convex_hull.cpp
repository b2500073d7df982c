// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/convex_hull.hpp"

#include <cmath>
#include <numbers>

namespace counterpart::numerics {

std::vector<bool> on_convex_hull(PointsView points, double tolerance) {
    constexpr int n_directions = 2000;
    std::vector<bool> on_hull(static_cast<std::size_t>(points.rows()), false);
    if (points.rows() == 0) return on_hull;
    const Points centered = points.rowwise() - points.colwise().mean();
    const double slack = tolerance * centered.rowwise().norm().maxCoeff();
    for (int i = 0; i < n_directions; ++i) {
        // Fibonacci lattice on the sphere.
        const double z = 1 - (2 * i + 1.0) / n_directions, r = std::sqrt(1 - z * z);
        const double angle = 2 * std::numbers::pi * i / std::numbers::phi;
        const Vector reach = centered * Eigen::Vector3d(r * std::cos(angle), r * std::sin(angle), z);
        const double least = reach.maxCoeff() - slack;
        for (Eigen::Index p = 0; p < points.rows(); ++p)
            if (reach[p] >= least) on_hull[static_cast<std::size_t>(p)] = true;
    }
    return on_hull;
}

}  // namespace counterpart::numerics
