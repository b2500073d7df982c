// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "render/ray_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace counterpart::render {
namespace {

using Bounds = Eigen::AlignedBox3f;

constexpr std::uint32_t leaf_size = 4;
constexpr int n_bins = 16;
constexpr int most_splits_by_area = 40;  // on one way down; deeper ones halve
constexpr std::size_t stack_size = 80;   // these, and 32 that halve

Bounds box_of(const Shape& shape) {
    Bounds box(shape.a);
    box.extend(shape.b);
    if (shape.radius == 0) return box.extend(shape.c);
    return {box.min().array() - shape.radius, box.max().array() + shape.radius};
}

float half_area(const Bounds& box) {
    if (box.isEmpty()) return 0;
    const Eigen::Vector3f d = box.sizes();
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

// By Pluecker coordinates of the edges (as Embree's robust mode), so that of two triangles with a common edge
// one is met by a ray through it.
std::optional<Meeting> meet_triangle(const Shape& shape, const Ray& ray) {
    const Eigen::Vector3f a = shape.a - ray.origin, b = shape.b - ray.origin, c = shape.c - ray.origin;
    const Eigen::Vector3f ca = c - a, ab = a - b, bc = b - c;
    const float beside_ca = ca.cross(c + a).dot(ray.direction),
                beside_ab = ab.cross(a + b).dot(ray.direction),
                beside_bc = bc.cross(b + c).dot(ray.direction);
    const float sum = beside_ca + beside_ab + beside_bc;
    const float slack = std::numeric_limits<float>::epsilon() * std::abs(sum);
    if (std::min({beside_ca, beside_ab, beside_bc}) < -slack &&
        std::max({beside_ca, beside_ab, beside_bc}) > slack)
        return std::nullopt;
    const Eigen::Vector3f normal = ca.cross(ab);
    const float t = a.dot(normal) / normal.dot(ray.direction);
    if (sum == 0 || !(t >= ray.near && t <= ray.far)) return std::nullopt;
    return Meeting{0, t, beside_ca / sum, beside_ab / sum, normal};
}

// The interval of t in which a quadratic is negative: a t^2 + 2 b t + c.
struct Interval {
    double begin = std::numeric_limits<double>::infinity(), end = -begin;
    static Interval of(double a, double b, double c) {
        const double square = b * b - a * c;
        if (!(square >= 0) || a <= 0) return {};
        return {(-b - std::sqrt(square)) / a, (-b + std::sqrt(square)) / a};
    }
    void unite(const Interval& other) {
        begin = std::min(begin, other.begin), end = std::max(end, other.end);
    }
};

std::optional<Meeting> meet_rounded(const Shape& shape, const Ray& ray) {
    const Eigen::Vector3d d = ray.direction.cast<double>(), axis = (shape.b - shape.a).cast<double>(),
                          from_a = (ray.origin - shape.a).cast<double>(), from_b = from_a - axis;
    const double square = static_cast<double>(shape.radius) * static_cast<double>(shape.radius),
                 length2 = axis.squaredNorm();
    const double dd = d.squaredNorm(), da = d.dot(axis), oa = from_a.dot(axis);
    Interval inside = Interval::of(dd, d.dot(from_a), from_a.squaredNorm() - square);
    if (length2 > 0) {
        inside.unite(Interval::of(dd, d.dot(from_b), from_b.squaredNorm() - square));
        // The cylinder, as far as it goes.
        const Interval body = Interval::of(dd - da * da / length2, d.dot(from_a) - da * oa / length2,
                                           from_a.squaredNorm() - oa * oa / length2 - square);
        for (const double t : {body.begin, body.end})
            if (oa + t * da >= 0 && oa + t * da <= length2) inside.unite({t, t});
    }
    if (!(inside.begin <= inside.end)) return std::nullopt;
    const double t = inside.begin >= static_cast<double>(ray.near) ? inside.begin : inside.end;
    if (!(t >= static_cast<double>(ray.near) && t <= static_cast<double>(ray.far))) return std::nullopt;
    const Eigen::Vector3d point = from_a + t * d;
    const double along = length2 > 0 ? std::clamp(point.dot(axis) / length2, 0.0, 1.0) : 0;
    return Meeting{0, static_cast<float>(t), 0, 0, (point - along * axis).cast<float>()};
}

std::optional<Meeting> meet(const Shape& shape, const Ray& ray) {
    return shape.radius > 0 ? meet_rounded(shape, ray) : meet_triangle(shape, ray);
}

}  // namespace

struct RayTree::Builder {
    RayTree& tree;
    std::vector<Shape> shapes;
    std::vector<Bounds> boxes;

    void build(std::uint32_t begin, std::uint32_t end, int depth) {
        const auto at = tree.nodes_.size();
        Bounds box, centers;
        for (std::uint32_t i = begin; i < end; ++i) {
            box.extend(boxes[tree.given_[i]]);
            centers.extend(boxes[tree.given_[i]].center());
        }
        tree.nodes_.push_back({box, begin, end - begin, 0});
        if (end - begin <= leaf_size) return;
        const std::uint32_t middle = split(begin, end, centers, depth);
        tree.nodes_[at].n_shapes = 0;
        build(begin, middle, depth + 1);
        tree.nodes_[at].second_child = static_cast<std::uint32_t>(tree.nodes_.size());
        build(middle, end, depth + 1);
    }

    // Where the areas of both boxes, times what they hold, are least; in halves where no plane parts the
    // centers.
    std::uint32_t split(std::uint32_t begin, std::uint32_t end, const Bounds& centers, int depth) {
        Eigen::Index axis = 0;
        const float width = centers.sizes().maxCoeff(&axis), least = centers.min()[axis];
        if (!(width > 0) || depth >= most_splits_by_area) return begin + (end - begin) / 2;
        const auto bin_of = [&](std::uint32_t shape) {
            const float at = (boxes[shape].center()[axis] - least) / width;
            return std::min(n_bins - 1, static_cast<int>(at * n_bins));
        };
        std::array<Bounds, n_bins> box;
        std::array<std::uint32_t, n_bins> count{};
        for (std::uint32_t i = begin; i < end; ++i) {
            const auto bin = static_cast<std::size_t>(bin_of(tree.given_[i]));
            box[bin].extend(boxes[tree.given_[i]]);
            ++count[bin];
        }
        std::array<float, n_bins> cost{};  // of what lies from this bin on
        Bounds rest;
        for (std::size_t bin = n_bins, n = 0; bin-- > 1;) {
            rest.extend(box[bin]);
            n += count[bin];
            cost[bin] = half_area(rest) * static_cast<float>(n);
        }
        int best = 1;
        Bounds before;
        float least_cost = std::numeric_limits<float>::infinity();
        for (std::size_t bin = 1, n = 0; bin < n_bins; ++bin) {
            before.extend(box[bin - 1]);
            n += count[bin - 1];
            const float whole = half_area(before) * static_cast<float>(n) + cost[bin];
            if (whole < least_cost) least_cost = whole, best = static_cast<int>(bin);
        }
        const auto first = tree.given_.begin();
        const auto middle = std::stable_partition(first + begin, first + end,
                                                  [&](std::uint32_t shape) { return bin_of(shape) < best; });
        const auto result = static_cast<std::uint32_t>(middle - first);
        return result == begin || result == end ? begin + (end - begin) / 2 : result;
    }
};

RayTree::RayTree(std::vector<Shape> shapes) : given_(shapes.size()) {
    std::iota(given_.begin(), given_.end(), 0U);
    if (shapes.empty()) return;
    Builder builder{*this, {}, {}};
    builder.boxes.reserve(shapes.size());
    for (const Shape& shape : shapes) builder.boxes.push_back(box_of(shape));
    nodes_.reserve(2 * shapes.size() / leaf_size);
    builder.build(0, static_cast<std::uint32_t>(shapes.size()), 0);
    box_ = nodes_.front().box;
    shapes_.reserve(shapes.size());
    for (const std::uint32_t shape : given_) shapes_.push_back(shapes[shape]);
}

// visit(begin, end) returns how far is still of interest; nearer children first.
template <class Visit>
void RayTree::visit_leaves(const Ray& ray, const Visit& visit) const {
    if (nodes_.empty()) return;
    constexpr float tiny = 1e-30F;  // in place of zero, by which nothing is divided
    const Eigen::Vector3f inverse =
        ray.direction.unaryExpr([](float x) { return 1 / (std::abs(x) < tiny ? tiny : x); });
    constexpr float missed = std::numeric_limits<float>::infinity();
    float far = ray.far;
    const auto entry = [&](const Bounds& box) {
        const Eigen::Vector3f low = (box.min() - ray.origin).cwiseProduct(inverse),
                              high = (box.max() - ray.origin).cwiseProduct(inverse);
        const float in = std::max(low.cwiseMin(high).maxCoeff(), ray.near);
        const float out = low.cwiseMax(high).minCoeff() * (1 + 4 * std::numeric_limits<float>::epsilon());
        return in <= std::min(out, far) ? in : missed;
    };
    struct Waiting {
        std::uint32_t node;
        float entry;
    };
    std::array<Waiting, stack_size> stack;
    std::size_t n_waiting = 0;
    if (const float at = entry(nodes_.front().box); at != missed) stack[n_waiting++] = {0, at};
    while (n_waiting > 0) {
        const Waiting next = stack[--n_waiting];
        if (next.entry > far) continue;
        const Node& node = nodes_[next.node];
        if (node.n_shapes > 0) {
            far = visit(node.first_shape, node.first_shape + node.n_shapes);
            continue;
        }
        Waiting nearer{next.node + 1, entry(nodes_[next.node + 1].box)};
        Waiting farther{node.second_child, entry(nodes_[node.second_child].box)};
        if (farther.entry < nearer.entry) std::swap(nearer, farther);
        if (farther.entry != missed) stack[n_waiting++] = farther;
        if (nearer.entry != missed) stack[n_waiting++] = nearer;
    }
}

std::optional<Meeting> RayTree::first(const Ray& ray) const {
    std::optional<Meeting> best;
    Ray shorter = ray;
    visit_leaves(ray, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::optional<Meeting> met = meet(shapes_[i], shorter);
            if (!met) continue;
            best = met;
            best->shape = given_[i];
            shorter.far = met->t;
        }
        return shorter.far;
    });
    return best;
}

bool RayTree::meets_any(const Ray& ray) const {
    bool met = false;
    visit_leaves(ray, [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end && !met; ++i) met = meet(shapes_[i], ray).has_value();
        return met ? -std::numeric_limits<float>::infinity() : ray.far;
    });
    return met;
}

}  // namespace counterpart::render
