// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/morton_order.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace counterpart::numerics {
std::vector<Index> space_filling_order(PointsView points) {
    if (points.rows() == 0) return {};
    const Eigen::RowVector3d low = points.colwise().minCoeff();
    const double extent = (points.colwise().maxCoeff() - low).maxCoeff();
    constexpr double cells = (1 << 20) - 1;
    const double scale = extent > 0 ? cells / extent : 0;
    std::vector<std::pair<std::uint64_t, Index>> coded(static_cast<std::size_t>(points.rows()));
    for (Index v = 0; v < static_cast<Index>(points.rows()); ++v) {
        const auto cell = [&](int axis) {
            return static_cast<std::uint64_t>((points(v, axis) - low[axis]) * scale);
        };
        coded[static_cast<std::size_t>(v)] = {morton_code(cell(0), cell(1), cell(2)), v};
    }
    std::sort(coded.begin(), coded.end());
    std::vector<Index> order;
    order.reserve(coded.size());
    for (const auto& [code, v] : coded) order.push_back(v);
    return order;
}

}  // namespace counterpart::numerics
