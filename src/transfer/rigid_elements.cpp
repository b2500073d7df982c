// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "transfer/rigid_elements.hpp"

#include "base/parallel.hpp"
#include "mesh/disjoint_sets.hpp"
#include "mesh/fans.hpp"
#include "numerics/nearest_neighbors.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/mesh/adjacency.hpp>

#include <algorithm>
#include <limits>
#include <numbers>
#include <queue>
#include <tuple>

namespace counterpart::morphing {
namespace {

// Half the cotangent of the angle opposite to each side.
Points half_cotangents(PointsView vertices, TrianglesView triangles) {
    Points result(triangles.rows(), 3);
    for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Eigen::RowVector3d apex = vertices.row(triangles(t, (c + 2) % 3));
            const Eigen::RowVector3d u = vertices.row(triangles(t, c)) - apex;
            const Eigen::RowVector3d v = vertices.row(triangles(t, (c + 1) % 3)) - apex;
            const double sine = u.cross(v).norm();
            result(t, c) = sine > 0 ? 0.5 * u.dot(v) / sine : 0;
        }
    }
    return result;
}

using Link = std::pair<Index, Index>;

// The closest pairs of vertices first (Kruskal), as far as they are among each other's nearest; what is left
// apart then hangs on the nearest vertex of the group of vertex 0.
std::vector<Link> links_between(const Components& components, PointsView vertices) {
    std::vector<Link> result;
    if (components.count <= 1) return result;
    const auto count = static_cast<std::size_t>(vertices.rows());
    constexpr int reach = 12;
    const numerics::NearestNeighbors neighbors(vertices);
    std::vector<std::vector<numerics::NearestNeighbors::Neighbor>> near(count);
    parallel_for(count, 256, [&](std::size_t v) {
        near[v] = neighbors.closest(vertices.row(static_cast<Eigen::Index>(v)), reach);
    });
    std::vector<std::tuple<double, Index, Index>> candidates;
    for (std::size_t v = 0; v < count; ++v) {
        for (const auto& [w, squared] : near[v]) {
            if (components.of_vertex[v] != components.of_vertex[static_cast<std::size_t>(w)])
                candidates.emplace_back(squared, static_cast<Index>(v), w);
        }
    }
    std::sort(candidates.begin(), candidates.end());
    mesh::DisjointSets groups(static_cast<Index>(count));
    std::vector<Index> first(static_cast<std::size_t>(components.count), -1);
    for (std::size_t v = 0; v < count; ++v) {
        Index& head = first[static_cast<std::size_t>(components.of_vertex[v])];
        if (head < 0) head = static_cast<Index>(v);
        groups.join(head, static_cast<Index>(v));
    }
    const auto link = [&](Index a, Index b) {
        if (groups.root(a) == groups.root(b)) return;
        groups.join(a, b);
        result.emplace_back(a, b);
    };
    for (const auto& [squared, a, b] : candidates) link(a, b);

    std::vector<Index> root;
    for (Index v = 0; v < static_cast<Index>(count); ++v)
        if (groups.root(v) == groups.root(0)) root.push_back(v);
    const numerics::NearestNeighbors nearest_root(Points(vertices(root, Eigen::all)));
    for (Index v = 0; v < static_cast<Index>(count); ++v) {
        const Index w = root[static_cast<std::size_t>(nearest_root.closest(vertices.row(v)).index)];
        link(v, w);
    }
    return result;
}

// 2 pi n around the axis of `vector` brings it nearest to `neighbor`.
Eigen::Vector3d nearest_branch(const Eigen::Vector3d& vector, const Eigen::Vector3d& neighbor) {
    const double angle = vector.norm();
    if (angle < 1e-6) return vector;  // no axis to speak of
    const Eigen::Vector3d axis = vector / angle;
    const double turns = std::round((axis.dot(neighbor) - angle) / (2 * std::numbers::pi));
    return vector + 2 * std::numbers::pi * turns * axis;
}

// The rotation of one element; rank below 2 where the element has no normal in one of the poses.
numerics::FittedRotation element_rotation(const RigidElements& elements, Index t, PointsView first,
                                          PointsView last) {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 3; ++c) {
        covariance +=
            elements.side_weights(t, c) * elements.side(last, t, c).transpose() * elements.side(first, t, c);
    }
    const Eigen::RowVector3d before = elements.side(first, t, 0).cross(elements.side(first, t, 1));
    const Eigen::RowVector3d after = elements.side(last, t, 0).cross(elements.side(last, t, 1));
    // Maps normal to normal: the sides alone leave it to the signs of small numbers in a sliver.
    const Eigen::Matrix3d flat = covariance;
    if (before.norm() > 0 && after.norm() > 0)
        covariance += flat.norm() * after.normalized().transpose() * before.normalized();
    numerics::FittedRotation fit = numerics::fit_rotation(covariance);
    const double sides = elements.side(first, t, 0).norm() * elements.side(first, t, 1).norm();
    const double sides_after = elements.side(last, t, 0).norm() * elements.side(last, t, 1).norm();
    if (before.norm() <= 1e-9 * sides || after.norm() <= 1e-9 * sides_after) fit.rank = 1;
    return fit;
}

// Non-manifold sides are joined in a chain.
Triangles elements_across(TrianglesView corners, Index n_triangles) {
    struct Side {
        Index a, b, element;
        int side;
    };
    std::vector<Side> sides;
    sides.reserve(static_cast<std::size_t>(n_triangles) * 3);
    for (Index t = 0; t < n_triangles; ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index a = corners(t, c), b = corners(t, (c + 1) % 3);
            if (a != b) sides.push_back({std::min(a, b), std::max(a, b), t, c});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
        return std::tie(x.a, x.b, x.element, x.side) < std::tie(y.a, y.b, y.element, y.side);
    });
    Triangles across = Triangles::Constant(corners.rows(), 3, -1);
    for (std::size_t i = 1; i < sides.size(); ++i) {
        const Side &x = sides[i - 1], &y = sides[i];
        if (x.a != y.a || x.b != y.b) continue;
        across(y.element, y.side) = x.element;
        if (across(x.element, x.side) < 0) across(x.element, x.side) = y.element;
    }
    return across;
}

}  // namespace

RigidElements make_rigid_elements(MeshView first, PointsView last) {
    const std::vector<Link> links = links_between(connected_components(Adjacency(first)), first.vertices);
    const Index n_triangles = first.n_triangles();
    RigidElements elements;
    elements.corners.resize(n_triangles + static_cast<Index>(links.size()), 3);
    elements.corners.topRows(n_triangles) = first.triangles;
    elements.side_weights.resize(elements.corners.rows(), 3);
    elements.side_weights.topRows(n_triangles) =
        half_cotangents(first.vertices, first.triangles) + half_cotangents(last, first.triangles);
    // Negative weights (obtuse triangles) would reward stretching, huge ones (slivers) drown the rest.
    elements.side_weights = elements.side_weights.cwiseMax(0.05).cwiseMin(20);
    for (std::size_t i = 0; i < links.size(); ++i) {
        const auto row = n_triangles + static_cast<Eigen::Index>(i);
        elements.corners.row(row) << links[i].first, links[i].second, links[i].second;
        elements.side_weights.row(row).setOnes();
    }
    elements.across = elements_across(elements.corners, n_triangles);
    return elements;
}

Points rotation_field(const RigidElements& elements, PointsView first, PointsView last) {
    const auto count = static_cast<std::size_t>(elements.count());
    Points vectors = Points::Zero(elements.count(), 3);
    std::vector<char> known(count, 0), done(count, 0);
    parallel_for(count, 64, [&](std::size_t t) {
        const numerics::FittedRotation fit = element_rotation(elements, static_cast<Index>(t), first, last);
        known[t] = fit.rank >= 2;
        vectors.row(static_cast<Eigen::Index>(t)) =
            numerics::rotation_vector(Eigen::Quaterniond(fit.rotation)).transpose();
    });
    Index root = 0;
    double least = std::numeric_limits<double>::infinity();
    for (Index t = 0; t < elements.count(); ++t) {
        if (known[static_cast<std::size_t>(t)] && vectors.row(t).norm() < least) {
            least = vectors.row(t).norm();
            root = t;
        }
    }
    // Grows from neighbor to neighbor, the smoothest steps first, so that odd elements are reached last and
    // do not mislead.
    const mesh::Fans fans(elements.corners, static_cast<Index>(first.rows()));
    using Step = std::tuple<double, Index, Index>;  // difference, element, the one it follows
    std::priority_queue<Step, std::vector<Step>, std::greater<>> steps;
    steps.emplace(0, root, root);
    while (!steps.empty()) {
        const auto [difference, t, from] = steps.top();
        steps.pop();
        const auto i = static_cast<std::size_t>(t);
        if (done[i]) continue;
        done[i] = 1;
        const Eigen::Vector3d lead = vectors.row(from).transpose();
        const Eigen::Vector3d mine = known[i] ? nearest_branch(vectors.row(t).transpose(), lead) : lead;
        vectors.row(t) = mine.transpose();
        for (const Index v : elements.corners.row(t)) {
            for (const Index u : fans.around(v)) {
                if (done[static_cast<std::size_t>(u)]) continue;
                const double step = known[static_cast<std::size_t>(u)]
                                        ? (nearest_branch(vectors.row(u).transpose(), mine) - mine).norm()
                                        : 2 * std::numbers::pi;
                steps.emplace(step, u, t);
            }
        }
    }
    return vectors;
}

// Each region takes the rotation of its surroundings, harmonically extended, and bends the rest in that
// frame.
RotationField soften_folds(const RigidElements& elements, Points vectors, const std::vector<Index>& seeds,
                           int rings) {
    constexpr double largest = 2.5;  // radians; neighbors of a smooth field differ by far less
    constexpr int rounds = 200;
    std::vector<char> in_patch(static_cast<std::size_t>(elements.count()), 0);
    std::vector<Index> patch = seeds;
    for (const Index t : seeds) in_patch[static_cast<std::size_t>(t)] = 1;
    for (Index t = 0; t < elements.count(); ++t) {
        for (const Index u : elements.across.row(t)) {
            if (u < 0 || (vectors.row(t) - vectors.row(u)).norm() <= largest) continue;
            if (!in_patch[static_cast<std::size_t>(t)]) patch.push_back(t);
            in_patch[static_cast<std::size_t>(t)] = 1;
        }
    }
    const mesh::Fans fans(elements.corners, elements.corners.maxCoeff() + 1);
    for (int ring = 0; ring < rings; ++ring) {
        for (std::size_t i = 0, end = patch.size(); i < end; ++i) {
            for (const Index v : elements.corners.row(patch[i])) {
                for (const Index u : fans.around(v)) {
                    if (!in_patch[static_cast<std::size_t>(u)]) patch.push_back(u);
                    in_patch[static_cast<std::size_t>(u)] = 1;
                }
            }
        }
    }
    for (const Index t : patch) vectors.row(t).setZero();
    for (int round = 0; round < rounds; ++round) {
        for (const Index t : patch) {
            Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
            int n = 0;
            for (const Index u : elements.across.row(t)) {
                if (u < 0) continue;
                sum += vectors.row(u);
                ++n;
            }
            if (n > 0) vectors.row(t) = sum / n;
        }
    }
    return {std::move(vectors), std::move(in_patch)};
}

}  // namespace counterpart::morphing
