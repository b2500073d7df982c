// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::numerics {

/// The place along the Morton curve (G. M. Morton 1966) of a cell, numbered from 0 along each axis: their
/// bits in turn, of each the lowest 21.
constexpr std::uint64_t morton_code(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    // Moves bit i to bit 3 i.
    const auto spread = [](std::uint64_t bits) {
        bits = (bits | bits << 32) & 0x001f00000000ffff;
        bits = (bits | bits << 16) & 0x001f0000ff0000ff;
        bits = (bits | bits << 8) & 0x100f00f00f00f00f;
        bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
        return (bits | bits << 2) & 0x1249249249249249;
    };
    return spread(x) | spread(y) << 1 | spread(z) << 2;
}

/// The points' indices in the order of the Morton curve through their bounding cube: points that are near in
/// space are mostly near in this order. Ties (equal cells, 2^20 along each axis) by number. O(N log N).
std::vector<Index> space_filling_order(PointsView points);

}  // namespace counterpart::numerics
