// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/camera.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace counterpart::render {
namespace {

// Chosen by 115 people and animals of nine sets, 53 of which y or z by flatness alone lays down, these 16.
constexpr double lowest = 0.1;      // share of the height that touches the ground (0.05 .. 0.2)
constexpr double may_lean = 0.1;    // of the diagonal: so far the center may be beside its support (0 .. 0.1)
constexpr double height_power = 4;  // legs are long and light: the center is high (0 .. 6)
constexpr double clearly_better = 2;  // than the usual axis (1.5 .. 5)

// Corners of the convex hull, counterclockwise (Andrew 1979).
std::vector<Eigen::Vector2d> convex_polygon(std::vector<Eigen::Vector2d> points) {
    std::sort(points.begin(), points.end(),
              [](const auto& a, const auto& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Eigen::Vector2d> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = hull.size();
        for (const Eigen::Vector2d& p : points) {
            const auto turns_left = [&](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
                return (b.x() - a.x()) * (p.y() - a.y()) > (b.y() - a.y()) * (p.x() - a.x());
            };
            while (hull.size() >= first + 2 && !turns_left(hull[hull.size() - 2], hull.back()))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other half begins with it
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

double polygon_area(const std::vector<Eigen::Vector2d>& polygon) {
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return twice / 2;
}

// How far a point is beyond the lines of a convex polygon; negative inside.
double beyond(const std::vector<Eigen::Vector2d>& polygon, const Eigen::Vector2d& point) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Eigen::Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i], to = point - polygon[i];
        const double length = edge.norm();
        if (length > 0) farthest = std::max(farthest, (edge.y() * to.x() - edge.x() * to.y()) / length);
    }
    return farthest;
}

// How well the mesh stands with an axis up or, with sign -1, down: the area between its feet as a share of
// that of its shadow, times a power of the height of its center as a share of its own; 0 where it falls over.
double standing(const Points& points, const Eigen::RowVector3d& center, int axis, int sign) {
    const auto on_ground = [&](const Eigen::RowVector3d& p) {
        return Eigen::Vector2d(p[(axis + 1) % 3], p[(axis + 2) % 3]);
    };
    const Vector height = sign * points.col(axis);
    const double low = height.minCoeff(), tall = height.maxCoeff() - low;
    std::vector<Eigen::Vector2d> feet, shadow;
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        shadow.push_back(on_ground(points.row(v)));
        if (height[v] <= low + lowest * tall) feet.push_back(shadow.back());
    }
    const std::vector<Eigen::Vector2d> support = convex_polygon(feet);
    const double diagonal = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
    const double whole = polygon_area(convex_polygon(shadow));
    if (!(tall > 0 && whole > 0) || beyond(support, on_ground(center)) > may_lean * diagonal) return 0;
    return polygon_area(support) / whole * std::pow((sign * center[axis] - low) / tall, height_power);
}

}  // namespace

std::string find_up_axis(MeshView mesh) {
    require_valid(mesh);
    const Vector areas = vertex_areas(mesh);
    std::vector<Index> used;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        if (areas[v] > 0) used.push_back(v);
    if (used.empty()) return "y";
    const Points points = mesh.vertices(used, Eigen::all);
    const Eigen::RowVector3d size = points.colwise().maxCoeff() - points.colwise().minCoeff();
    const bool lies_along_y = size.y() < 0.6 * size.z() && size.y() < 0.6 * size.x() + 0.25 * size.z();
    const std::string usual = lies_along_y ? "z" : "y";
    const double area = areas.sum();
    if (!(area > 0 && std::isfinite(area))) return usual;

    const Eigen::RowVector3d center = areas.transpose() * mesh.vertices / area;
    struct Axis {
        const char* name;
        int axis, sign;
    };
    std::string best = usual;
    double most = clearly_better * standing(points, center, lies_along_y ? 2 : 1, 1);
    for (const auto& [name, axis, sign] : {Axis{"y", 1, 1}, {"z", 2, 1}, {"-y", 1, -1}}) {
        const double stands = standing(points, center, axis, sign);
        if (name == usual || stands <= most) continue;
        most = stands;
        best = name;
    }
    return best;
}

}  // namespace counterpart::render
