// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/oriented_neighbors.hpp"

#include <nanoflann.hpp>

namespace counterpart::numerics {

struct OrientedNeighbors::Tree {
    Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor> rows;
    double normal_weight;

    std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(rows.rows()); }
    double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
        return rows(static_cast<Eigen::Index>(index), static_cast<Eigen::Index>(dimension));
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }

    using Search =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, 6, Index>;
    std::unique_ptr<Search> search;

    Tree(PointsView points, PointsView normals, double weight)
        : rows(points.rows(), 6), normal_weight(weight) {
        rows << points, weight * normals;
        search = std::make_unique<Search>(6, *this, nanoflann::KDTreeSingleIndexAdaptorParams(10));
    }
};

OrientedNeighbors::OrientedNeighbors(PointsView points, PointsView normals, double normal_weight)
    : tree_(std::make_unique<Tree>(points, normals, normal_weight)) {}
OrientedNeighbors::~OrientedNeighbors() = default;

Index OrientedNeighbors::closest(const Eigen::RowVector3d& point, const Eigen::RowVector3d& normal) const {
    Eigen::Matrix<double, 1, 6> query;
    query << point, tree_->normal_weight * normal;
    Index index = -1;
    double squared = 0;
    nanoflann::KNNResultSet<double, Index> found(1);
    found.init(&index, &squared);
    tree_->search->findNeighbors(found, query.data(), {});
    return index;
}

}  // namespace counterpart::numerics
