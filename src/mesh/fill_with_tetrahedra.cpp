// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Cubes inside a surface, each cut along its diagonal into six tetrahedra, after Kuhn 1960: neighbors are cut
// alike where they meet.
#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace counterpart {
namespace {

class CubeGrid {
  public:
    CubeGrid(MeshView surface, int cells) : low_(surface.vertices.colwise().minCoeff()) {
        const Eigen::RowVector3d size = surface.vertices.colwise().maxCoeff() - low_;
        side_ = size.maxCoeff() / cells;
        if (!(side_ > 0)) throw InvalidInput("the surface has no extent to fill");
        for (int k = 0; k < 3; ++k)
            count_[static_cast<std::size_t>(k)] =
                std::max<Index>(1, static_cast<Index>(std::ceil(size[k] / side_ - 1e-9)));
        crossings_.resize(static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(count_[2]));
        for (Index t = 0; t < surface.n_triangles(); ++t) cross(surface, t);
        for (auto& line : crossings_) std::sort(line.begin(), line.end());
    }

    TetrahedralMesh fill() {
        std::vector<Index> number(static_cast<std::size_t>(count_[0] + 1) *
                                      static_cast<std::size_t>(count_[1] + 1) *
                                      static_cast<std::size_t>(count_[2] + 1),
                                  -1);
        std::vector<double> points;
        std::vector<Index> corners;
        const auto vertex_at = [&](Index x, Index y, Index z) {
            Index& v = number[static_cast<std::size_t>(x) +
                              static_cast<std::size_t>(count_[0] + 1) *
                                  (static_cast<std::size_t>(y) +
                                   static_cast<std::size_t>(count_[1] + 1) * static_cast<std::size_t>(z))];
            if (v < 0) {
                v = static_cast<Index>(points.size() / 3);
                points.insert(points.end(), {low_[0] + side_ * x, low_[1] + side_ * y, low_[2] + side_ * z});
            }
            return v;
        };
        // From corner 0 along the axes in each order to the opposite corner; odd orders with two corners
        // exchanged, so that none is inverted.
        constexpr std::array<std::array<int, 3>, 6> orders = {
            {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
        for (Index z = 0; z < count_[2]; ++z) {
            for (Index y = 0; y < count_[1]; ++y) {
                for (Index x = 0; x < count_[0]; ++x) {
                    if (!is_inside(x, y, z)) continue;
                    for (std::size_t k = 0; k < orders.size(); ++k) {
                        std::array<Index, 3> at = {x, y, z};
                        std::array<Index, 4> tetrahedron = {vertex_at(x, y, z)};
                        for (std::size_t step = 0; step < 3; ++step) {
                            ++at[static_cast<std::size_t>(orders[k][step])];
                            tetrahedron[step + 1] = vertex_at(at[0], at[1], at[2]);
                        }
                        if (k >= 3) std::swap(tetrahedron[1], tetrahedron[2]);
                        corners.insert(corners.end(), tetrahedron.begin(), tetrahedron.end());
                    }
                }
            }
        }
        if (corners.empty())
            throw InvalidInput("no cube lies inside the surface: is it closed? try more cells");
        return {
            Eigen::Map<const Points>(points.data(), static_cast<Eigen::Index>(points.size() / 3), 3),
            Eigen::Map<const Tetrahedra>(corners.data(), static_cast<Eigen::Index>(corners.size() / 4), 4)};
    }

  private:
    // Where the lines along x through the middles of the cubes meet the triangle.
    void cross(MeshView surface, Index t) {
        std::array<Eigen::RowVector3d, 3> p;
        for (int c = 0; c < 3; ++c)
            p[static_cast<std::size_t>(c)] = (surface.vertices.row(surface.triangles(t, c)) - low_) / side_;
        const double area =
            (p[1][1] - p[0][1]) * (p[2][2] - p[0][2]) - (p[1][2] - p[0][2]) * (p[2][1] - p[0][1]);
        if (area == 0) return;
        const auto range = [&](int k, Index count) {
            const auto [low, high] = std::minmax({p[0][k], p[1][k], p[2][k]});
            return std::pair(std::max<Index>(0, static_cast<Index>(std::ceil(low - 0.5 - shift_))),
                             std::min(count - 1, static_cast<Index>(std::floor(high - 0.5 + shift_))));
        };
        const auto [y_first, y_last] = range(1, count_[1]);
        const auto [z_first, z_last] = range(2, count_[2]);
        for (Index z = z_first; z <= z_last; ++z) {
            for (Index y = y_first; y <= y_last; ++y) {
                // Off the middle by a little: a line through an edge would count both triangles or none.
                const double qy = y + 0.5 + shift_ * 0.6180339887, qz = z + 0.5 + shift_ * 0.4142135623;
                std::array<double, 3> weight{};
                for (std::size_t c = 0; c < 3; ++c) {
                    const Eigen::RowVector3d &a = p[(c + 1) % 3], &b = p[(c + 2) % 3];
                    weight[c] = ((a[1] - qy) * (b[2] - qz) - (a[2] - qz) * (b[1] - qy)) / area;
                }
                if (*std::min_element(weight.begin(), weight.end()) < 0) continue;
                crossings_[line(y, z)].push_back(weight[0] * p[0][0] + weight[1] * p[1][0] +
                                                 weight[2] * p[2][0]);
            }
        }
    }

    std::size_t line(Index y, Index z) const {
        return static_cast<std::size_t>(y) +
               static_cast<std::size_t>(count_[1]) * static_cast<std::size_t>(z);
    }

    bool is_inside(Index x, Index y, Index z) const {
        const std::vector<double>& at = crossings_[line(y, z)];
        return (std::upper_bound(at.begin(), at.end(), x + 0.5) - at.begin()) % 2 == 1;
    }

    static constexpr double shift_ = 1e-6;  // sides
    Eigen::RowVector3d low_;
    double side_ = 0;
    std::array<Index, 3> count_{};
    std::vector<std::vector<double>> crossings_;  // by line, in sides from the grid's corner
};

}  // namespace

TetrahedralMesh fill_with_tetrahedra(MeshView surface, int cells) {
    require_valid(surface);
    if (cells < 1 || cells > 256) throw InvalidInput("cells must be 1 to 256");
    return CubeGrid(surface, cells).fill();
}

}  // namespace counterpart
