// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/morton_order.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace counterpart::numerics {
namespace {

// Moves bit i to bit 3 i, for the lowest 21 bits.
std::uint64_t spread_bits(std::uint64_t x) {
    x = (x | x << 32) & 0x001f00000000ffff;
    x = (x | x << 16) & 0x001f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    x = (x | x << 2) & 0x1249249249249249;
    return x;
}

}  // namespace

std::vector<Index> space_filling_order(PointsView points) {
    if (points.rows() == 0) return {};
    const Eigen::RowVector3d low = points.colwise().minCoeff();
    const double extent = (points.colwise().maxCoeff() - low).maxCoeff();
    constexpr double cells = (1 << 20) - 1;
    const double scale = extent > 0 ? cells / extent : 0;
    std::vector<std::pair<std::uint64_t, Index>> coded(static_cast<std::size_t>(points.rows()));
    for (Index v = 0; v < static_cast<Index>(points.rows()); ++v) {
        std::uint64_t code = 0;
        for (int axis = 0; axis < 3; ++axis)
            code |= spread_bits(static_cast<std::uint64_t>((points(v, axis) - low[axis]) * scale)) << axis;
        coded[static_cast<std::size_t>(v)] = {code, v};
    }
    std::sort(coded.begin(), coded.end());
    std::vector<Index> order;
    order.reserve(coded.size());
    for (const auto& [code, v] : coded) order.push_back(v);
    return order;
}

}  // namespace counterpart::numerics
