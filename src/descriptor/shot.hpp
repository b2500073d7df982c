// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/nearest_neighbors.hpp"
#include "numerics/product_search.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <span>

namespace counterpart::descriptor {

constexpr int shot_size = 320;

/// A surface as points that are weighted by the area they stand for, ready for SHOT at any radius.
class ShotSurface {
  public:
    /// `normals` per vertex; points about `spacing` apart, or as dense as the triangles if those are smaller.
    ShotSurface(MeshView mesh, PointsView normals, double spacing);

    /// One row per vertex, the signatures at the given radii side by side: vertices x (320 radii.size()).
    numerics::MatrixF operator()(std::span<const Index> vertices, std::span<const double> radii) const;

  private:
    struct Cloud {
        Points points, normals;
        Vector areas;
    };
    static Cloud cloud_of(MeshView mesh, PointsView normals, double spacing);

    Points vertices_, vertex_normals_;
    Cloud cloud_;
    numerics::NearestNeighbors search_;
};

}  // namespace counterpart::descriptor
