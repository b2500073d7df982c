// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/surface_box.hpp"
#include "numerics/moments.hpp"
#include "numerics/rotation.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/camera.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

namespace counterpart::render {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Covariance of the surface's points.
Eigen::Matrix3d surface_covariance(MeshView mesh) {
    const Vector areas = vertex_areas(mesh);
    const double total = areas.sum();
    if (!(total > 0)) return Eigen::Matrix3d::Identity();
    const Eigen::RowVector3d mean = numerics::weighted_mean(mesh.vertices, areas);
    const Points centered = mesh.vertices.rowwise() - mean;
    return numerics::cross_moments(centered, areas, centered) / total;
}

Eigen::Vector3d find_up(MeshView mesh, const std::string& name) {
    if (name == "auto") return find_up(mesh, find_up_axis(mesh));
    for (const auto& [axis, direction] : {std::pair{"x", 0}, {"y", 1}, {"z", 2}}) {
        if (name == axis) return Eigen::Vector3d::Unit(direction);
        if (name == std::string("-") + axis) return -Eigen::Vector3d::Unit(direction);
    }
    throw InvalidInput("the up axis must be auto, x, y, z, -x, -y or -z, not '" + name + "'");
}

/// By convention of mesh formats: y up looks along -z, z up along +y.
Eigen::Vector3d find_front(const Eigen::Vector3d& up) {
    return std::abs(up.z()) > 0.5 ? Eigen::Vector3d(0, -1, 0) : Eigen::Vector3d(0, 0, 1);
}

/// The horizontal direction in which the surface is thinnest, on the front's side.
Eigen::Vector3d thinnest(MeshView mesh, const Eigen::Vector3d& up, const Eigen::Vector3d& front) {
    const Eigen::Vector3d side = up.cross(front);
    Eigen::Matrix<double, 3, 2> plane;
    plane << side, front;
    const Eigen::Matrix2d spread = plane.transpose() * surface_covariance(mesh) * plane;
    const double mean = spread.trace() / 2, difference = (spread(0, 0) - spread(1, 1)) / 2;
    const double deviation = std::hypot(difference, spread(0, 1));  // eigenvalues: mean -+ deviation
    // A round surface has no thinnest side: its front then.
    if (mean - deviation > 0.8 * (mean + deviation)) return front;
    const double widest = std::atan2(spread(0, 1), difference) / 2;
    const Eigen::Vector3d axis = plane * Eigen::Vector2d(-std::sin(widest), std::cos(widest));
    const double ahead = axis.dot(front), aside = axis.dot(side);
    const double sign = std::abs(ahead) > 0.1 ? ahead : aside;
    return sign < 0 ? Eigen::Vector3d(-axis) : axis;
}

std::optional<std::pair<double, double>> parse_angles(const std::string& text) {
    double azimuth = 0, elevation = 0;
    const char* end = text.data() + text.size();
    auto [comma, first] = std::from_chars(text.data(), end, azimuth);
    if (first != std::errc() || comma == end || *comma != ',') return {};
    auto [rest, second] = std::from_chars(comma + 1, end, elevation);
    if (second != std::errc() || rest != end || !std::isfinite(azimuth) || !(std::abs(elevation) <= 90))
        return {};
    return std::pair{azimuth, elevation};
}

/// Seen from `front` turned right by `azimuth` about `up` and raised by `elevation`, degrees.
Camera look_from(const Eigen::Vector3d& front, const Eigen::Vector3d& up, double azimuth, double elevation) {
    const Eigen::Vector3d turned = Eigen::AngleAxisd(azimuth * degree, up) * front;
    const Eigen::Vector3d right = up.cross(turned);
    Camera view;
    view.row(0) = right;
    view.row(1) = std::cos(elevation * degree) * up - std::sin(elevation * degree) * turned;
    view.row(2) = std::cos(elevation * degree) * turned + std::sin(elevation * degree) * up;
    return view;
}

}  // namespace

Camera find_camera(MeshView mesh, const CameraOptions& options) {
    const Eigen::Vector3d up = find_up(mesh, options.up), front = find_front(up);
    if (options.direction == "auto") {
        const Eigen::Vector3d from = thinnest(mesh, up, front);
        return look_from(from, up, -20, 10);
    }
    struct Named {
        const char* name;
        double azimuth, elevation;
    };
    constexpr std::array named = {Named{"front", 0, 0},  Named{"right", 90, 0}, Named{"back", 180, 0},
                                  Named{"left", -90, 0}, Named{"top", 0, 90},   Named{"bottom", 0, -90}};
    for (const Named& view : named)
        if (options.direction == view.name) return look_from(front, up, view.azimuth, view.elevation);
    if (const auto angles = parse_angles(options.direction))
        return look_from(front, up, angles->first, angles->second);
    throw InvalidInput(
        "the view direction must be auto, front, back, left, right, top, bottom or AZIMUTH,ELEVATION in "
        "degrees (elevation from -90 to 90), not '" +
        options.direction + "'");
}

Camera matching_camera(const Camera& source_view, MeshView source, MeshView target,
                       const VertexMap& target_from_source) {
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    const Index n = count_matched(target_from_source);
    if (n < 3) return source_view;
    Points from(n, 3), to(n, 3);
    for (Index v = 0, k = 0; v < source.n_vertices(); ++v) {
        if (target_from_source[v] == VertexMap::unmatched) continue;
        from.row(k) = source.vertices.row(v);
        to.row(k++) = target.vertices.row(target_from_source[v]);
    }
    from.rowwise() -= from.colwise().mean().eval();
    const Eigen::Matrix3d target_from_source_rotation =
        numerics::fit_rotation(numerics::cross_moments(to, from)).rotation;
    const double angle = Eigen::AngleAxisd(target_from_source_rotation).angle();
    if (!std::isfinite(angle) || angle < 40 * degree) return source_view;
    return source_view * target_from_source_rotation.transpose();
}

Placement::Placement(MeshView mesh, const Camera& view) : view_(view) {
    const Points seen = mesh.vertices * view.transpose();
    const Eigen::AlignedBox3d box = mesh::surface_box({seen, mesh.triangles});
    const Eigen::RowVector3d low = box.min().transpose(), high = box.max().transpose();
    const double area = surface_area(mesh);
    scale_ = area > 0 ? 1 / std::sqrt(area) : 1 / std::max(1e-300, (high - low).maxCoeff());
    offset_ = -0.5 * scale_ * (low + high);
    half_size_ = 0.5 * scale_ * (high - low);
}

TriangleMesh Placement::operator()(MeshView mesh) const {
    return {(scale_ * (mesh.vertices * view_.transpose())).rowwise() + offset_, mesh.triangles};
}

}  // namespace counterpart::render
