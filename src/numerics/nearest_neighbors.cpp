// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/nearest_neighbors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <nanoflann.hpp>

namespace counterpart::numerics {
namespace {

using Neighbor = NearestNeighbors::Neighbor;

bool nearer(const Neighbor& a, const Neighbor& b) {
    return std::pair(a.squared_distance, a.index) < std::pair(b.squared_distance, b.index);
}

// What nanoflann fills during a search; `DistanceType` and `sort` are asked for since its version 1.5. Here
// the neighbors closest to the query, nearest first, with ties broken by index.
class Closest {
  public:
    using DistanceType = double;
    explicit Closest(std::size_t capacity) : capacity_(capacity) { found_.reserve(capacity); }

    std::size_t size() const { return found_.size(); }
    bool full() const { return found_.size() == capacity_; }
    // nanoflann skips what is not below this, so a tie must lie below it.
    double worstDist() const {
        return full()
                   ? std::nextafter(found_.back().squared_distance, std::numeric_limits<double>::infinity())
                   : std::numeric_limits<double>::max();
    }
    bool addPoint(double squared_distance, Index index) {
        const Neighbor candidate{index, squared_distance};
        if (full() && !nearer(candidate, found_.back())) return true;
        if (full()) found_.pop_back();
        found_.insert(std::upper_bound(found_.begin(), found_.end(), candidate, nearer), candidate);
        return true;
    }

    void sort() {}
    std::vector<Neighbor> take() { return std::move(found_); }
    const Neighbor& best() const { return found_.front(); }

  private:
    std::size_t capacity_;
    std::vector<Neighbor> found_;
};

// Everything up to a distance, in the order of the tree.
class Within {
  public:
    using DistanceType = double;
    // Only what is below the bound is found: the radius itself is to belong to it.
    explicit Within(double radius)
        : bound_(std::nextafter(radius * radius, std::numeric_limits<double>::infinity())) {}

    std::size_t size() const { return found_.size(); }
    bool full() const { return true; }
    double worstDist() const { return bound_; }
    bool addPoint(double squared_distance, Index index) {
        if (squared_distance < bound_) found_.push_back({index, squared_distance});
        return true;
    }
    void sort() {}

    std::vector<Neighbor> take() { return std::move(found_); }

  private:
    double bound_;
    std::vector<Neighbor> found_;
};

}  // namespace

struct NearestNeighbors::Tree {
    Points points;

    std::size_t kdtree_get_point_count() const { return static_cast<std::size_t>(points.rows()); }
    double kdtree_get_pt(std::size_t index, std::size_t dimension) const {
        return points(static_cast<Eigen::Index>(index), static_cast<Eigen::Index>(dimension));
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
        return false;
    }

    using Search =
        nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Tree>, Tree, 3, Index>;
    Search search;

    explicit Tree(Points p)
        : points(std::move(p)), search(3, *this, nanoflann::KDTreeSingleIndexAdaptorParams(10)) {}
};

NearestNeighbors::NearestNeighbors(Points points) : tree_(std::make_unique<Tree>(std::move(points))) {}
NearestNeighbors::~NearestNeighbors() = default;
NearestNeighbors::NearestNeighbors(NearestNeighbors&&) noexcept = default;
NearestNeighbors& NearestNeighbors::operator=(NearestNeighbors&&) noexcept = default;

Neighbor NearestNeighbors::closest(const Eigen::RowVector3d& query) const {
    Closest closest(1);
    tree_->search.findNeighbors(closest, query.data(), {});
    return closest.size() > 0 ? closest.best() : Neighbor{};
}

std::vector<Neighbor> NearestNeighbors::closest(const Eigen::RowVector3d& query, int count) const {
    if (count <= 0) return {};
    Closest closest(static_cast<std::size_t>(count));
    tree_->search.findNeighbors(closest, query.data(), {});
    return closest.take();
}

std::vector<Neighbor> NearestNeighbors::within(const Eigen::RowVector3d& query, double radius) const {
    Within within(radius);
    tree_->search.findNeighbors(within, query.data(), {});
    return within.take();
}

}  // namespace counterpart::numerics
