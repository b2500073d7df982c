// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "descriptor/shot.hpp"

#include "base/parallel.hpp"
#include "numerics/moments.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/descriptor/descriptors.hpp>
#include <counterpart/mesh/measure.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace counterpart {
namespace descriptor {
namespace {

constexpr int n_sectors = 8, n_cosines = 10;

// A point of the surface near the one that is described.
struct NearPoint {
    Eigen::Vector3d offset, normal;
    double distance = 0, area = 0;
};

// The axes of the frame are the columns: x along the widest spread, z along the normal.
Eigen::Matrix3d local_frame(const std::vector<NearPoint>& points, const Eigen::Vector3d& normal,
                            double radius) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const NearPoint& p : points)
        if (p.distance < radius)
            numerics::add_outer(spread, p.area * (radius - p.distance), p.offset, p.offset);
    const Eigen::Matrix3d axes = numerics::symmetric_eigen(spread).vectors;
    Eigen::Vector3d z = axes.col(0), x = axes.col(2);
    if (z.dot(normal) < 0) z = -z;
    double side = 0;
    for (const NearPoint& p : points) {
        if (p.distance >= radius) continue;
        const double t = p.offset.dot(x);
        side += p.area * (radius - p.distance) * t * std::abs(t);
    }
    if (side < 0) x = -x;
    Eigen::Matrix3d frame;
    frame << x, z.cross(x), z;
    return frame;
}

// A coordinate between the centers of two bins.
struct Between {
    int below = 0;
    double fraction = 0;

    explicit Between(double place) : below(static_cast<int>(std::floor(place))), fraction(place - below) {}
    double weight(int i) const { return i == 0 ? 1 - fraction : fraction; }
};

void add_to_histogram(const NearPoint& p, const Eigen::Matrix3d& frame, double radius, float* histogram) {
    const Eigen::Vector3d local = frame.transpose() * p.offset;
    const double turn = std::atan2(local.y(), local.x()) / (2 * std::numbers::pi) * n_sectors;
    const Between sector((turn < 0 ? turn + n_sectors : turn) - 0.5);
    const Between half(std::acos(std::clamp(local.z() / p.distance, -1.0, 1.0)) / std::numbers::pi * 2 - 0.5);
    const Between shell(p.distance / radius * 2 - 0.5);
    const Between cosine((frame.col(2).dot(p.normal) + 1) / 2 * n_cosines - 0.5);
    // Rows of a histogram hold the cosines of one sector, half and shell.
    const std::array<int, 2> shells{std::clamp(shell.below, 0, 1) * n_cosines,
                                    std::clamp(shell.below + 1, 0, 1) * n_cosines},
        cosines{std::clamp(cosine.below, 0, n_cosines - 1), std::clamp(cosine.below + 1, 0, n_cosines - 1)};
    for (int a = 0; a < 2; ++a) {
        const int at_sector = (sector.below + a + n_sectors) % n_sectors;
        for (int h = 0; h < 2; ++h) {
            float* const rows =
                histogram + (at_sector * 2 + std::clamp(half.below + h, 0, 1)) * 2 * n_cosines;
            const auto share = static_cast<float>(p.area * sector.weight(a) * half.weight(h));
            for (int s = 0; s < 2; ++s)
                for (int c = 0; c < 2; ++c)
                    rows[shells[s] + cosines[c]] +=
                        share * static_cast<float>(shell.weight(s) * cosine.weight(c));
        }
    }
}

// `histogram` must hold zeros.
void describe(const std::vector<NearPoint>& points, const Eigen::Vector3d& normal, double radius,
              float* histogram) {
    const auto n =
        std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.distance < radius; });
    if (n < 5) return;  // no frame
    const Eigen::Matrix3d frame = local_frame(points, normal, radius);
    for (const NearPoint& p : points)
        if (p.distance < radius && p.distance > 1e-9 * radius) add_to_histogram(p, frame, radius, histogram);
    double squares = 0;
    for (int i = 0; i < shot_size; ++i) squares += static_cast<double>(histogram[i]) * histogram[i];
    if (!(squares > 0)) return;
    for (int i = 0; i < shot_size; ++i) histogram[i] = static_cast<float>(histogram[i] / std::sqrt(squares));
}

}  // namespace

ShotSurface::Cloud ShotSurface::cloud_of(MeshView mesh, PointsView normals, double spacing) {
    const Vector areas = triangle_areas(mesh);
    std::vector<int> cuts;  // of each edge of a triangle: cuts^2 points
    Eigen::Index n = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        cuts.push_back(
            std::clamp(static_cast<int>(std::ceil(std::sqrt(areas[t]) / spacing - 1e-9)), 1, 1000));
        n += cuts.back() * cuts.back();
    }
    Cloud cloud{Points(n, 3), Points(n, 3), Vector(n)};
    n = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const int m = cuts[static_cast<std::size_t>(t)];
        const Eigen::Matrix3d corners = mesh.vertices(mesh.triangles.row(t), Eigen::all),
                              corner_normals = normals(mesh.triangles.row(t), Eigen::all);
        for (int i = 0; i < m; ++i)
            for (int j = 0; j < 2 * (m - i) - 1; ++j) {  // the row's triangles, in turns upright and inverted
                const double a = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3) / m;
                const int pair = j / 2;
                const double b = (pair + (j % 2 == 0 ? 1.0 : 2.0) / 3) / m;
                const Eigen::RowVector3d weights(1 - a - b, a, b);
                cloud.points.row(n) = weights * corners;
                cloud.normals.row(n) = (weights * corner_normals).normalized();
                cloud.areas[n++] = areas[t] / (m * m);
            }
    }
    return cloud;
}

ShotSurface::ShotSurface(MeshView mesh, PointsView normals, double spacing)
    : vertices_(mesh.vertices),
      vertex_normals_(normals),
      cloud_(cloud_of(mesh, normals, spacing)),
      search_(cloud_.points) {}

numerics::MatrixF ShotSurface::operator()(std::span<const Index> vertices,
                                          std::span<const double> radii) const {
    const double reach = *std::max_element(radii.begin(), radii.end());
    numerics::MatrixF rows = numerics::MatrixF::Zero(static_cast<Eigen::Index>(vertices.size()),
                                                     shot_size * static_cast<Eigen::Index>(radii.size()));
    parallel_for(vertices.size(), 4, [&](std::size_t i) {
        const Eigen::RowVector3d center = vertices_.row(vertices[i]);
        std::vector<NearPoint> points;
        for (const auto& [j, squared] : search_.within(center, reach))
            points.push_back({(cloud_.points.row(j) - center).transpose(), cloud_.normals.row(j).transpose(),
                              std::sqrt(squared), cloud_.areas[j]});
        for (std::size_t r = 0; r < radii.size(); ++r)
            describe(points, vertex_normals_.row(vertices[i]).transpose(), radii[r],
                     rows.row(static_cast<Eigen::Index>(i)).data() + shot_size * r);
    });
    return rows;
}

}  // namespace descriptor

Matrix shot(MeshView mesh, std::span<const Index> vertices, const ShotOptions& options) {
    require_valid(mesh);
    if (!(options.radius > 0) || !(options.spacing >= 0) || !std::isfinite(options.radius + options.spacing))
        throw InvalidInput(fmt::format("the radius must be above 0 and the spacing at least 0, not {} and {}",
                                       options.radius, options.spacing));
    for (const Index v : vertices)
        if (v < 0 || v >= mesh.n_vertices())
            throw InvalidInput(
                fmt::format("vertex {} is out of range: the mesh has {}", v, mesh.n_vertices()));
    const double spacing = options.spacing > 0 ? options.spacing : options.radius / 15;
    return with_threads(options.n_threads, [&] {
        const descriptor::ShotSurface surface(mesh, vertex_normals(mesh), spacing);
        return Matrix(surface(vertices, std::array{options.radius}).cast<double>());
    });
}

}  // namespace counterpart
