// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include <Eigen/Geometry>

namespace counterpart::numerics {
namespace {

constexpr Index leaf_size = 4;

double squared_distance_to_box(const Eigen::Array3d& query, const Eigen::Array3d& low,
                               const Eigen::Array3d& high) {
    return (low - query).max(query - high).max(0.0).square().sum();
}

ClosestPoint on_segment(const Eigen::Vector3d& query, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                        int corner_a, int corner_b) {
    const Eigen::Vector3d edge = b - a;
    const double squared = edge.squaredNorm();
    const double along = squared > 0 ? std::clamp(edge.dot(query - a) / squared, 0.0, 1.0) : 0.0;
    ClosestPoint point{0, Eigen::Vector3d::Zero(), (a + along * edge - query).squaredNorm()};
    point.weights[corner_a] = 1 - along;
    point.weights[corner_b] = along;
    return point;
}

ClosestPoint on_edges(const Eigen::Vector3d& query, const std::array<Eigen::Vector3d, 3>& corners) {
    ClosestPoint best;
    for (int c = 0; c < 3; ++c) {
        const int next = (c + 1) % 3;
        const ClosestPoint point = on_segment(query, corners[static_cast<std::size_t>(c)],
                                              corners[static_cast<std::size_t>(next)], c, next);
        if (point.squared_distance < best.squared_distance) best = point;
    }
    return best;
}

}  // namespace

ClosestPoint closest_on_triangle(const Eigen::Vector3d& query, const Eigen::Vector3d& a,
                                 const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    const Eigen::Vector3d ab = b - a, ac = c - a, normal = ab.cross(ac);
    const double scale = normal.squaredNorm();
    // Relative to the edges, so that a tiny but well-shaped triangle is none the worse.
    if (scale <= 1e-24 * ab.squaredNorm() * ac.squaredNorm()) return on_edges(query, {a, b, c});
    const Eigen::Vector3d ap = query - a;
    const double weight_b = normal.dot(ap.cross(ac)) / scale;
    const double weight_c = normal.dot(ab.cross(ap)) / scale;
    const double weight_a = 1 - weight_b - weight_c;
    if (weight_a <= 0 || weight_b <= 0 || weight_c <= 0) return on_edges(query, {a, b, c});
    const Eigen::Vector3d weights(weight_a, weight_b, weight_c);
    const double height = normal.dot(ap);
    return {0, weights, height * height / scale};
}

ClosestPoint closest_among(std::span<const Index> among, PointsView vertices, TrianglesView triangles,
                           const Eigen::Vector3d& query) {
    ClosestPoint best;
    for (const Index t : among) {
        ClosestPoint point =
            closest_on_triangle(query, vertices.row(triangles(t, 0)), vertices.row(triangles(t, 1)),
                                vertices.row(triangles(t, 2)));
        point.triangle = t;
        if (point.squared_distance < best.squared_distance) best = point;
    }
    return best;
}

ClosestTriangle::ClosestTriangle(Points vertices, Triangles triangles)
    : vertices_(std::move(vertices)), triangles_(std::move(triangles)) {
    const auto count = static_cast<Index>(triangles_.rows());
    normals_.resize(count, 3);
    Points centers(count, 3);
    for (Index t = 0; t < count; ++t) {
        const Eigen::RowVector3d a = vertices_.row(triangles_(t, 0)), b = vertices_.row(triangles_(t, 1)),
                                 c = vertices_.row(triangles_(t, 2));
        normals_.row(t) = (b - a).cross(c - a).stableNormalized();
        centers.row(t) = (a + b + c) / 3;
    }
    order_.resize(static_cast<std::size_t>(count));
    std::iota(order_.begin(), order_.end(), 0);
    nodes_.reserve(order_.size());
    if (count > 0) build(0, count, centers);
}

void ClosestTriangle::build(Index begin, Index end, PointsView centers) {
    const std::size_t mine = nodes_.size();
    Node node{Eigen::Array3d::Constant(std::numeric_limits<double>::infinity()),
              Eigen::Array3d::Constant(-std::numeric_limits<double>::infinity()),
              begin,
              end,
              0,
              *std::min_element(order_.begin() + begin, order_.begin() + end)};
    for (Index i = begin; i < end; ++i) {
        for (int c = 0; c < 3; ++c) {
            const Eigen::Array3d corner =
                vertices_.row(triangles_(order_[static_cast<std::size_t>(i)], c)).transpose().array();
            node.low = node.low.min(corner);
            node.high = node.high.max(corner);
        }
    }
    nodes_.push_back(node);
    if (end - begin <= leaf_size) return;
    Eigen::Index axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const Index middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](Index a, Index b) {
                         const double x = centers(a, axis), y = centers(b, axis);
                         return x != y ? x < y : a < b;
                     });
    build(begin, middle, centers);
    nodes_[mine].right = static_cast<Index>(nodes_.size());
    build(middle, end, centers);
}

ClosestPoint ClosestTriangle::search(const Eigen::Vector3d& query, const Eigen::Vector3d& normal,
                                     double least_cosine, double radius) const {
    ClosestPoint best;
    best.squared_distance = radius * radius;
    std::array<Index, 64> stack{};  // the tree is balanced: depth below log2 of the number of triangles
    std::size_t depth = 0;
    if (!nodes_.empty()) stack[depth++] = 0;
    while (depth > 0) {
        const Index number = stack[--depth];
        const Node& node = nodes_[static_cast<std::size_t>(number)];
        const double at_least = squared_distance_to_box(query.array(), node.low, node.high);
        if (at_least > best.squared_distance) continue;
        // At the tip of a fan all triangles are equally close.
        if (at_least == best.squared_distance && best.triangle >= 0 && node.first > best.triangle) continue;
        if (node.right != 0) {
            const Node& left = nodes_[static_cast<std::size_t>(number) + 1];
            const Node& right = nodes_[static_cast<std::size_t>(node.right)];
            const bool left_first = squared_distance_to_box(query.array(), left.low, left.high) <=
                                    squared_distance_to_box(query.array(), right.low, right.high);
            stack[depth++] = left_first ? node.right : number + 1;
            stack[depth++] = left_first ? number + 1 : node.right;
            continue;
        }
        for (Index i = node.begin; i < node.end; ++i) {
            const Index t = order_[static_cast<std::size_t>(i)];
            if (normals_.row(t).dot(normal) <= least_cosine) continue;
            const ClosestPoint point = on(t, query);
            if (point.squared_distance < best.squared_distance ||
                (point.squared_distance == best.squared_distance &&
                 (best.triangle < 0 || t < best.triangle))) {
                best = point;
            }
        }
    }
    return best;
}

std::vector<ClosestPoint> ClosestTriangle::all_within(const Eigen::Vector3d& query,
                                                      const Eigen::Vector3d& normal, double least_cosine,
                                                      double radius, std::size_t most) const {
    std::vector<ClosestPoint> found;
    std::vector<Index> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty() && found.size() <= most) {
        const Index number = open.back();
        open.pop_back();
        const Node& node = nodes_[static_cast<std::size_t>(number)];
        if (squared_distance_to_box(query.array(), node.low, node.high) > radius * radius) continue;
        if (node.right != 0) {
            open.insert(open.end(), {node.right, number + 1});
            continue;
        }
        for (Index i = node.begin; i < node.end && found.size() <= most; ++i) {
            const Index t = order_[static_cast<std::size_t>(i)];
            if (normals_.row(t).dot(normal) <= least_cosine) continue;
            const ClosestPoint point = on(t, query);
            if (point.squared_distance <= radius * radius) found.push_back(point);
        }
    }
    std::sort(found.begin(), found.end(),
              [](const ClosestPoint& a, const ClosestPoint& b) { return a.triangle < b.triangle; });
    return found;
}

ClosestPoint ClosestTriangle::on(Index triangle, const Eigen::Vector3d& query) const {
    ClosestPoint point = closest_on_triangle(query, vertices_.row(triangles_(triangle, 0)).transpose(),
                                             vertices_.row(triangles_(triangle, 1)).transpose(),
                                             vertices_.row(triangles_(triangle, 2)).transpose());
    point.triangle = triangle;
    return point;
}

Eigen::Vector3d ClosestTriangle::position(const ClosestPoint& point) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int c = 0; c < 3; ++c)
        sum += point.weights[c] * vertices_.row(triangles_(point.triangle, c)).transpose();
    return sum;
}

}  // namespace counterpart::numerics
