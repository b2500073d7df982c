// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/rotation.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/transfer/local_linear_maps.hpp>
#include <counterpart/transfer/normals.hpp>

#include <Eigen/Geometry>

namespace counterpart {
namespace {

// For each row the mean normal of the triangles that use it; zero where undefined.
Points geometric_normals(const TriangleMesh& mesh, const Triangles& corners, Eigen::Index n_rows) {
    const Points directions = triangle_normals(mesh);
    const Vector areas = triangle_areas(mesh);
    Points sums = Points::Zero(n_rows, 3);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (const Index row : corners.row(t))
            if (row >= 0) sums.row(row) += areas[t] * directions.row(t);
    for (auto row : sums.rowwise()) row.stableNormalize();
    return sums;
}

// How the surface turns at the vertex of each row. Where a normal leans, the two geometric normals alone do
// not tell where to.
std::vector<Eigen::Matrix3d> turns_of_rows(const SurfaceMap& map, const TriangleMesh& source,
                                           const TriangleMesh& target, const CornerAttribute& carried) {
    std::vector<Eigen::Matrix3d> turns(static_cast<std::size_t>(carried.values.rows()),
                                       Eigen::Matrix3d::Identity());
    constexpr double leaning = 1e-3;
    if (((carried.values.leftCols<3>() - carried.values.rightCols<3>()).rowwise().norm().array() < leaning)
            .all())
        return turns;
    const std::vector<Eigen::Matrix3d> maps = local_linear_maps(map, source, target);
    for (Index t = 0; t < target.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index row = carried.corners(t, c);
            if (row < 0) continue;
            turns[static_cast<std::size_t>(row)] =
                fit_rotation(maps[static_cast<std::size_t>(target.triangles(t, c))]).rotation;
        }
    }
    return turns;
}

}  // namespace

CarriedCorners carry_normals(const SurfaceMap& source_from_target, const TriangleMesh& source,
                             const TriangleMesh& target, const CornerAttribute& normals,
                             const CarryCornersOptions& options) {
    if (normals.values.cols() != 3 || normals.corners.rows() != source.n_triangles() ||
        (normals.corners.size() > 0 && normals.corners.maxCoeff() >= normals.values.rows()))
        throw InvalidInput("the normals do not fit the source: three numbers each, three corners a triangle");
    // The geometric normals travel beside the given ones, through the same triangles.
    CornerAttribute both{Matrix(normals.values.rows(), 6), normals.corners};
    both.values << normals.values, geometric_normals(source, normals.corners, normals.values.rows());
    CarriedCorners carried = carry_corners(source_from_target, source, target, both, {}, options);
    const Matrix values = carried.attribute.values;
    const Points surface = geometric_normals(target, carried.attribute.corners, values.rows());
    const std::vector<Eigen::Matrix3d> turns =
        turns_of_rows(source_from_target, source, target, carried.attribute);
    carried.attribute.values.resize(values.rows(), 3);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        const Eigen::Vector3d given = values.row(row).head<3>(), from = values.row(row).tail<3>();
        const Eigen::Vector3d to = surface.row(row);
        const bool defined = !from.isZero() && !to.isZero();
        // Left alone where the two are one up to rounding, so that a copy gets the same numbers.
        const bool same = defined && (from.normalized() - to).norm() < 1e-12;
        Eigen::Vector3d normal = given;
        if (defined && !same) {
            const Eigen::Matrix3d& turn = turns[static_cast<std::size_t>(row)];
            normal = Eigen::Quaterniond::FromTwoVectors(turn * from, to) * (turn * given);
        }
        if (std::abs(normal.norm() - 1) > 1e-6) normal.stableNormalize();
        carried.attribute.values.row(row) = normal.transpose();
    }
    return carried;
}

}  // namespace counterpart
