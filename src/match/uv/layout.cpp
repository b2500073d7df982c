// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/uv/layout.hpp"

#include "base/to_size.hpp"
#include "mesh/edge_table.hpp"

#include <counterpart/base/errors.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

namespace counterpart::uv {
namespace {

void require_valid(const CornerAttribute& coordinates, MeshView mesh, const char* whose) {
    if (coordinates.values.rows() == 0 || coordinates.corners.rows() == 0)
        throw InvalidInput(fmt::format("the {} has no texture coordinates", whose));
    if (coordinates.values.cols() != 2 || coordinates.corners.rows() != mesh.triangles.rows() ||
        coordinates.corners.minCoeff() < -1 || coordinates.corners.maxCoeff() >= coordinates.values.rows())
        throw InvalidInput(fmt::format("the texture coordinates do not fit the {}", whose));
    constexpr double farthest = 1e6;
    for (Index row = 0; row < coordinates.values.rows(); ++row)
        if (!(coordinates.values.row(row).array().abs() <= farthest).all())  // nor NaN
            throw InvalidInput(fmt::format(
                "row {} of the texture coordinates of the {} is not within 1e6 of 0", row, whose));
}

// Twice the area in the layout, where (0, 0) is the top left: negative where counter-clockwise.
double doubled_area(const CornerAttribute& coordinates, Index t) {
    const auto at = [&](int c) -> Eigen::Vector2d {
        return coordinates.values.row(coordinates.corners(t, c)).transpose();
    };
    const Eigen::Vector2d ab = at(1) - at(0), ac = at(2) - at(0);
    const double area = ab[0] * ac[1] - ab[1] * ac[0];
    constexpr double rounding = 1e-12;  // relative to the edges: then only rounding tells the side
    return std::abs(area) > rounding * std::max(ab.squaredNorm(), ac.squaredNorm()) ? area : 0;
}

Index root_of(std::vector<Index>& parent, Index t) {
    while (parent[to_size(t)] != t) t = parent[to_size(t)] = parent[to_size(parent[to_size(t)])];
    return t;
}

// For each triangle one that stands for its chart.
std::vector<Index> joined(MeshView mesh, const CornerAttribute& coordinates,
                          const std::vector<double>& areas) {
    std::vector<Index> parent(areas.size());
    std::iota(parent.begin(), parent.end(), 0);
    const mesh::EdgeTable edges(mesh);
    const auto at_ends = [&](const mesh::EdgeTable::HalfEdge& half) {
        const Index here = coordinates.corners(half.triangle, half.corner),
                    next = coordinates.corners(half.triangle, (half.corner + 1) % 3);
        Eigen::Matrix<double, 2, 2> ends;
        ends << coordinates.values.row(half.forward ? here : next),
            coordinates.values.row(half.forward ? next : here);
        return ends;
    };
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto halves = edges.half_edges(e);
        for (std::size_t i = 1; i < halves.size(); ++i) {
            const auto &one = halves[i - 1], &other = halves[i];
            // Equal sides; 0 is in no chart.
            if (areas[to_size(one.triangle)] * areas[to_size(other.triangle)] > 0 &&
                at_ends(one) == at_ends(other))
                parent[to_size(root_of(parent, other.triangle))] = root_of(parent, one.triangle);
        }
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t) parent[to_size(t)] = root_of(parent, t);
    return parent;
}

}  // namespace

Layout::Layout(MeshView mesh, const CornerAttribute& coordinates, const char* whose)
    : mesh_(mesh), coordinates_(coordinates), plane_({}, {}) {
    require_valid(coordinates, mesh, whose);
    std::vector<double> areas(to_size(mesh.n_triangles()), 0);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        if (coordinates.corners.row(t).minCoeff() >= 0) areas[to_size(t)] = doubled_area(coordinates, t);
    const std::vector<Index> stands_for = joined(mesh, coordinates, areas);
    std::vector<Index> chart_of(areas.size(), -1);
    double doubled = 0, length = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (areas[to_size(t)] == 0) continue;
        Index& number = chart_of[to_size(stands_for[to_size(t)])];
        if (number < 0) {
            number = static_cast<Index>(facing_.size());
            facing_.emplace_back(0, 0, areas[to_size(t)] > 0 ? 1 : -1);
        }
        for (int c = 0; c < 3; ++c) {
            const Index row = coordinates.corners(t, c);
            corners_.push_back({number, mesh.triangles(t, c), row});
            length += (at(row) - at(coordinates.corners(t, (c + 1) % 3))).norm();
        }
        doubled += std::abs(areas[to_size(t)]);
        triangles_.push_back(t);
        charts_.push_back(number);
    }
    if (triangles_.empty())
        throw InvalidInput(fmt::format("the texture coordinates of the {} span no area", whose));
    std::sort(corners_.begin(), corners_.end());
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    size_ = std::sqrt(doubled / 2);
    edge_length_ = length / (3 * static_cast<double>(triangles_.size()));
    Points points(coordinates.values.rows(), 3);
    points << coordinates.values, Vector::Zero(coordinates.values.rows());
    plane_ = numerics::ClosestTriangle(std::move(points), coordinates.corners(triangles_, Eigen::all));
}

}  // namespace counterpart::uv
