// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/closest_triangle.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/carry_points.hpp>

#include <limits>

#include <fmt/format.h>

namespace counterpart {

Points carry_points(PointsView points, MeshView source, MeshView target,
                    const SurfaceMap& target_from_source) {
    require_valid(target_from_source, source.n_vertices(), target.n_triangles());
    const Points images = image_positions(target_from_source, target);
    const numerics::ClosestTriangle on_source(source.vertices, source.triangles);
    const numerics::ClosestTriangle on_target(target.vertices, target.triangles);
    Points carried = Points::Constant(points.rows(), 3, std::numeric_limits<double>::quiet_NaN());
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        if (!points.row(i).allFinite())
            throw InvalidInput(fmt::format("point {} has a coordinate that is not finite", i));
        const numerics::ClosestPoint nearest = on_source.closest(points.row(i).transpose());
        if (nearest.triangle < 0) continue;
        Eigen::Vector3d image = Eigen::Vector3d::Zero();
        double weight = 0;
        for (int c = 0; c < 3; ++c) {
            const Index corner = source.triangles(nearest.triangle, c);
            if (nearest.weights[c] == 0 || !target_from_source[corner].matched()) continue;
            image += nearest.weights[c] * images.row(corner).transpose();
            weight += nearest.weights[c];
        }
        if (weight > 0) carried.row(i) = on_target.position(on_target.closest(image / weight)).transpose();
    }
    return carried;
}

}  // namespace counterpart
