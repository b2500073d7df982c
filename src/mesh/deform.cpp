// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/random.hpp"
#include "numerics/moments.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/variants.hpp>

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Rows: the directions of largest, middle and smallest spread of the surface, each toward its longer tail
// (third moment), so that the pose does not depend on how the mesh lies in space.
Eigen::Matrix3d principal_axes(MeshView mesh, const Eigen::RowVector3d& center) {
    const Points offsets = mesh.vertices.rowwise() - center;
    const Vector weights = vertex_areas(mesh);
    const Eigen::Matrix3d spread = numerics::cross_moments(offsets, weights, offsets);
    Eigen::Matrix3d axes = numerics::symmetric_eigen(spread).vectors.rowwise().reverse().transpose();
    for (int i = 0; i < 2; ++i) {
        const Vector along = offsets * axes.row(i).transpose();
        if (along.array().cube().matrix().dot(weights) < 0) axes.row(i) *= -1;
    }
    axes.row(2) = axes.row(0).cross(axes.row(1));
    return axes;
}

// All below works in units of the length along the first axis, with the origin at its middle: that coordinate
// is in [-1/2, 1/2].

Eigen::Vector3d twisted(const Eigen::Vector3d& p, double angle) {
    return Eigen::AngleAxisd(angle * p.x(), Eigen::Vector3d::UnitX()) * p;
}

// The first axis becomes an arc of the same length, in the plane of the first and third axis.
Eigen::Vector3d bent(const Eigen::Vector3d& p, double angle) {
    if (std::abs(angle) < 1e-9) return p;
    const double radius = 1 / angle, phi = angle * p.x();
    return {(radius - p.z()) * std::sin(phi), p.y(), radius - (radius - p.z()) * std::cos(phi)};
}

// A few plane waves at most 1.5 periods long over the length: smooth, and with a gradient of a few times
// `warp`.
class Warp {
  public:
    explicit Warp(const DeformOptions& options) : amplitude_(options.warp / std::sqrt(double(n_waves))) {
        Random random(options.seed);
        const auto direction = [&] {
            return Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
        };
        for (Wave& wave : waves_) wave = {direction(), 1.5 * two_pi * direction(), random.uniform(0, two_pi)};
    }
    Eigen::Vector3d operator()(const Eigen::Vector3d& p) const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const Wave& wave : waves_)
            sum += std::sin(wave.frequency.dot(p) + wave.phase) * wave.displacement;
        return p + amplitude_ * sum;
    }

  private:
    static constexpr int n_waves = 6;
    struct Wave {
        Eigen::Vector3d displacement, frequency;
        double phase = 0;
    };
    double amplitude_;
    std::array<Wave, n_waves> waves_;
};

void require_range(const char* what, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw InvalidInput(
            fmt::format("deform: {} must be {:.4g} to {:.4g}, not {}", what, low, high, value));
}

}  // namespace

TriangleMesh deform(MeshView mesh, const DeformOptions& options) {
    require_valid(mesh);
    require_range("bend", options.bend, -two_pi, two_pi);
    require_range("twist", options.twist, -two_pi, two_pi);
    require_range("warp", options.warp, 0, 0.5);
    TriangleMesh result = mesh.copy();
    if (mesh.polygons != nullptr) result.polygons = *mesh.polygons;
    if (options.bend == 0 && options.twist == 0 && options.warp == 0) return result;  // to the last bit
    const Eigen::RowVector3d centroid = surface_centroid(mesh).transpose();
    const Eigen::Matrix3d axes = principal_axes(mesh, centroid);
    Points local = (mesh.vertices.rowwise() - centroid) * axes.transpose();
    const double low = local.col(0).minCoeff(), length = local.col(0).maxCoeff() - low;
    if (!(length > 0)) throw InvalidInput("deform: all vertices are at one point");
    const Eigen::RowVector3d middle(low + length / 2, 0, 0);
    const Warp warp(options);
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::Vector3d p = (local.row(v) - middle).transpose() / length;
        local.row(v) = length * warp(bent(twisted(p, options.twist), options.bend)).transpose() + middle;
    }
    result.vertices = (local * axes).rowwise() + centroid;
    return result;
}

}  // namespace counterpart
