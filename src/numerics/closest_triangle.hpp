// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <limits>
#include <span>
#include <vector>

namespace counterpart::numerics {

/// The point of a triangle closest to a query point.
struct ClosestPoint {
    Index triangle = -1;
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();  ///< of the corners; not negative, sum 1
    double squared_distance = std::numeric_limits<double>::infinity();
};

/// Ericson, Real-Time Collision Detection, 5.1.5. Exact weights (1, 0, 0) at corners. A degenerate triangle
/// is treated as its edges.
ClosestPoint closest_on_triangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                 const Eigen::Vector3d& b, const Eigen::Vector3d& c);

/// The closest point on some of a mesh's triangles, by brute force; of equally close ones the first.
/// triangle is -1 if `among` is empty.
ClosestPoint closest_among(std::span<const Index> among, PointsView vertices, TrianglesView triangles,
                           const Eigen::Vector3d& query);

/// Closest points on a triangle soup by a tree of boxes, in double precision. Keeps a copy of the mesh.
/// Building is O(F log F), a query about O(log F). Queries may run on several threads at once.
class ClosestTriangle {
  public:
    ClosestTriangle(Points vertices, Triangles triangles);

    /// The closest point; of equally close triangles the one with the smallest index. With a `normal` (unit)
    /// only triangles whose unit normal has a product above `least_cosine` with it count; triangle is -1 if
    /// there is none within `radius`.
    ClosestPoint closest(const Eigen::Vector3d& query,
                         double radius = std::numeric_limits<double>::infinity()) const {
        return search(query, Eigen::Vector3d::Zero(), -2, radius);
    }
    ClosestPoint closest(const Eigen::Vector3d& query, const Eigen::Vector3d& normal, double least_cosine,
                         double radius = std::numeric_limits<double>::infinity()) const {
        return search(query, normal, least_cosine, radius);
    }

    /// The points of the triangles within `radius` of the query whose unit normal has a product above
    /// `least_cosine` with `normal`, by triangles; of more than `most` triangles some `most` + 1.
    std::vector<ClosestPoint> all_within(const Eigen::Vector3d& query, const Eigen::Vector3d& normal,
                                         double least_cosine, double radius, std::size_t most) const;

    Eigen::Vector3d position(const ClosestPoint& point) const;
    PointsView normals() const { return normals_; }

  private:
    struct Node {
        Eigen::Array3d low, high;
        Index begin, end;  // leaf: triangles order_[begin .. end)
        Index right;       // inner: the left child follows its parent; 0 = leaf
        Index first;       // the smallest of its triangles
    };
    ClosestPoint on(Index triangle, const Eigen::Vector3d& query) const;
    void build(Index begin, Index end, PointsView centers);
    ClosestPoint search(const Eigen::Vector3d& query, const Eigen::Vector3d& normal, double least_cosine,
                        double radius) const;

    Points vertices_, normals_;
    Triangles triangles_;
    std::vector<Index> order_;
    std::vector<Node> nodes_;
};

}  // namespace counterpart::numerics
