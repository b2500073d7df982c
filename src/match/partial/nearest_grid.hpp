// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <array>
#include <vector>

namespace counterpart::partial_match {

/// Which of some points is nearest, looked up: exact to half a cell. What lies outside the grid is answered
/// as the grid's nearest cell is.
class NearestGrid {
  public:
    /// Cells of size `cell` reach `margin` beyond the points; larger ones where there would be too many.
    NearestGrid(PointsView points, double cell, double margin);

    Index operator()(const Eigen::Vector3f& x) const;

  private:
    std::size_t at(int i, int j, int k) const;

    float cell_;
    Eigen::Vector3f low_;
    std::array<int, 3> n_{};
    std::vector<Index> nearest_;
};

}  // namespace counterpart::partial_match
