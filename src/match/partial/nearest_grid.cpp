// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/nearest_grid.hpp"

#include "base/parallel.hpp"
#include "base/to_size.hpp"
#include "numerics/nearest_neighbors.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::partial_match {
namespace {

constexpr double max_cells = 500000;  // a thin shape lying across would fill any number of them

}  // namespace

NearestGrid::NearestGrid(PointsView points, double cell, double margin) {
    const Eigen::RowVector3d low = points.colwise().minCoeff().array() - margin,
                             high = points.colwise().maxCoeff().array() + margin;
    cell_ = static_cast<float>(std::max(cell, std::cbrt((high - low).prod() / max_cells)));
    low_ = low.transpose().cast<float>();
    for (int c = 0; c < 3; ++c)
        n_[to_size(c)] = std::max(1, static_cast<int>(std::ceil((high[c] - low[c]) / cell_)));
    nearest_.resize(to_size(n_[0]) * to_size(n_[1]) * to_size(n_[2]));
    const numerics::NearestNeighbors tree{Points(points)};
    parallel_for(to_size(n_[0]), 1, [&](std::size_t slice) {
        const int i = static_cast<int>(slice);
        for (int j = 0; j < n_[1]; ++j)
            for (int k = 0; k < n_[2]; ++k) {
                const Eigen::RowVector3d center = low + cell_ * Eigen::RowVector3d(i + 0.5, j + 0.5, k + 0.5);
                nearest_[at(i, j, k)] = tree.closest(center).index;
            }
    });
}

Index NearestGrid::operator()(const Eigen::Vector3f& x) const {
    const Eigen::Vector3f u = (x - low_) / cell_;
    const auto cell = [&](int c) {
        return static_cast<int>(std::clamp(u[c], 0.0F, static_cast<float>(n_[to_size(c)] - 1)));
    };
    return nearest_[at(cell(0), cell(1), cell(2))];
}

std::size_t NearestGrid::at(int i, int j, int k) const {
    return (to_size(i) * to_size(n_[1]) + to_size(j)) * to_size(n_[2]) + to_size(k);
}

}  // namespace counterpart::partial_match
