// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <memory>
#include <span>
#include <vector>

namespace counterpart::numerics {

/// A kd-tree over points in 3D. Keeps a copy of the points. Queries may run on several threads at once.
class NearestNeighbors {
  public:
    explicit NearestNeighbors(Points points);
    ~NearestNeighbors();
    NearestNeighbors(NearestNeighbors&&) noexcept;
    NearestNeighbors& operator=(NearestNeighbors&&) noexcept;

    struct Neighbor {
        Index index = -1;
        double squared_distance = 0;
    };
    /// The closest point; of equally close ones the smallest index.
    Neighbor closest(const Eigen::RowVector3d& query) const;
    /// The `count` closest points (fewer if there are fewer), nearest first, ties by index.
    std::vector<Neighbor> closest(const Eigen::RowVector3d& query, int count) const;
    /// All points within `radius`, in no particular order, but always the same one.
    std::vector<Neighbor> within(const Eigen::RowVector3d& query, double radius) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace counterpart::numerics
