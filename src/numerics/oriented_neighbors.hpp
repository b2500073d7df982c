// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <memory>

namespace counterpart::numerics {

/// The nearest of points that have a normal: by squared distance plus the squared difference of the normals
/// times normal_weight^2 (a length). A kd-tree in six dimensions. Queries may run on several threads at once.
class OrientedNeighbors {
  public:
    OrientedNeighbors(PointsView points, PointsView normals, double normal_weight);
    ~OrientedNeighbors();

    Index closest(const Eigen::RowVector3d& point, const Eigen::RowVector3d& normal) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace counterpart::numerics
