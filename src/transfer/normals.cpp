// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "base/parallel.hpp"
#include "mesh/edge_table.hpp"
#include "numerics/rotation.hpp"
#include "transfer/attributes.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <Eigen/Geometry>

namespace counterpart::attributes {
namespace {

// For each row the mean normal of the triangles that use it; zero where undefined.
Points geometric_normals(MeshView mesh, TrianglesView corners, Eigen::Index n_rows) {
    const Points directions = triangle_normals(mesh);
    const Vector areas = triangle_areas(mesh);
    Points sums = Points::Zero(n_rows, 3);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        for (const Index row : corners.row(t))
            if (row >= 0) sums.row(row) += areas[t] * directions.row(t);
    for (auto row : sums.rowwise()) row.stableNormalize();
    return sums;
}

// The rotation that best takes the edges around each target vertex, and its normal, from where they are on
// the source; none where that is not known.
std::vector<Eigen::Matrix3d> turns_of_vertices(const SurfaceMap& map, MeshView source, MeshView target) {
    const Points images = image_positions(map, source);
    const Matrix normals = transfer_values(map, source, vertex_normals(source));
    const Points target_normals = vertex_normals(target);
    const Adjacency adjacency(target);
    std::vector<Eigen::Matrix3d> turns(map.image.size(), Eigen::Matrix3d::Identity());
    parallel_for(turns.size(), 256, [&](std::size_t i) {
        const auto v = static_cast<Index>(i);
        if (!map[v].matched()) return;
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        for (const Index w : adjacency.neighbors(v)) {
            if (!map[w].matched()) continue;
            covariance += (target.vertices.row(w) - target.vertices.row(v)).transpose() *
                          (images.row(w) - images.row(v));
        }
        const double edges = covariance.norm();
        covariance += edges * target_normals.row(v).transpose() * normals.row(v);
        const numerics::FittedRotation fit = numerics::fit_rotation(covariance);
        if (fit.rank >= 2) turns[i] = fit.rotation;
    });
    return turns;
}

// The same for the vertex of each row. Where a normal leans, the two geometric normals alone do not tell
// where to.
std::vector<Eigen::Matrix3d> turns_of_rows(const SurfaceMap& map, MeshView source, MeshView target,
                                           const CornerAttribute& carried) {
    const std::vector<Eigen::Matrix3d> of_vertices = turns_of_vertices(map, source, target);
    std::vector<Eigen::Matrix3d> turns(static_cast<std::size_t>(carried.values.rows()),
                                       Eigen::Matrix3d::Identity());
    for (Index t = 0; t < target.n_triangles(); ++t) {
        for (int c = 0; c < 3; ++c) {
            const Index row = carried.corners(t, c);
            if (row >= 0)
                turns[static_cast<std::size_t>(row)] =
                    of_vertices[static_cast<std::size_t>(target.triangles(t, c))];
        }
    }
    return turns;
}

constexpr double same_direction = 0.9999;                  // cosine: files keep three to four digits
constexpr double least_bend = 0.9998, sharp_bend = 0.866;  // cosines of 1 and 30 degrees

}  // namespace

bool is_shaded_flat(MeshView mesh, const CornerAttribute& normals) {
    const Points directions = triangle_normals(mesh);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (directions.row(t).isZero(0)) continue;
        for (const Index row : normals.corners.row(t))
            if (row < 0 || normals.values.row(row).normalized().dot(directions.row(t)) < same_direction)
                return false;
    }
    Index n_bent = 0, n_sharp = 0;
    const mesh::EdgeTable edges(mesh);
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const auto sides = edges.half_edges(e);
        if (sides.size() != 2) continue;
        const double cosine = directions.row(sides[0].triangle).dot(directions.row(sides[1].triangle));
        n_bent += cosine < least_bend ? 1 : 0;
        n_sharp += cosine < sharp_bend ? 1 : 0;
    }
    return 2 * n_sharp < n_bent;
}

TransferredCorners transfer_normals(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                                    const CornerAttribute& normals, const TransferCornersOptions& options) {
    if (normals.values.cols() != 3 || normals.corners.rows() != source.n_triangles() ||
        (normals.corners.size() > 0 && normals.corners.maxCoeff() >= normals.values.rows()))
        throw InvalidInput(
            "the normals do not fit the source: each needs three coordinates, and each triangle three "
            "corners");
    // The geometric normals travel beside the given ones, through the same triangles.
    CornerAttribute both{Matrix(normals.values.rows(), 6), normals.corners};
    both.values << normals.values, geometric_normals(source, normals.corners, normals.values.rows());
    TransferredCorners carried = transfer_corners(source_from_target, source, target, both, {}, options);
    const Matrix values = carried.attribute.values;
    const Points surface = geometric_normals(target, carried.attribute.corners, values.rows());
    const std::vector<Eigen::Matrix3d> turns = with_threads(options.n_threads, [&] {
        return turns_of_rows(source_from_target, source, target, carried.attribute);
    });
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
            normal = numerics::shortest_rotation(turn * from, to) * (turn * given);
        }
        if (std::abs(normal.norm() - 1) > 1e-6) normal.stableNormalize();
        carried.attribute.values.row(row) = normal.transpose();
    }
    return carried;
}

}  // namespace counterpart::attributes
