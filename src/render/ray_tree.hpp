// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace counterpart::render {

/// The triangle a, b, c; with a radius, all points so near to the segment from a to b (a ball where these are
/// one).
struct Shape {
    Eigen::Vector3f a, b, c = Eigen::Vector3f::Zero();
    float radius = 0;
};

/// origin + t direction, for t from `near` to `far`; a unit direction.
struct Ray {
    Eigen::Vector3f origin, direction;
    float near, far;
};

/// Where a ray meets a shape.
struct Meeting {
    std::uint32_t shape;     ///< its place in the list that the tree was made of
    float t;                 ///< of the ray
    float u, v;              ///< in a triangle: the weights of b and c
    Eigen::Vector3f normal;  ///< of any length; of a triangle (b - a) x (c - a)
};

/// A tree of boxes around shapes, split where the surface area heuristic (MacDonald and Booth 1990; in bins:
/// Wald 2007) is least. Building takes O(n log n); the same shapes give the same tree. Safe to use from
/// several threads.
class RayTree {
  public:
    explicit RayTree(std::vector<Shape> shapes);

    std::optional<Meeting> first(const Ray& ray) const;
    bool meets_any(const Ray& ray) const;
    const Eigen::AlignedBox3f& box() const { return box_; }

  private:
    /// A leaf has shapes, an inner node two children, the first of which comes next.
    struct Node {
        Eigen::AlignedBox3f box;
        std::uint32_t first_shape, n_shapes, second_child;
    };
    struct Builder;
    template <class Visit>
    void visit_leaves(const Ray& ray, const Visit& visit) const;

    std::vector<Shape> shapes_;         // leaf by leaf
    std::vector<std::uint32_t> given_;  // the place that each had
    std::vector<Node> nodes_;
    Eigen::AlignedBox3f box_;
};

}  // namespace counterpart::render
