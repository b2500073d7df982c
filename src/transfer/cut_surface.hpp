// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "mesh/fans.hpp"
#include "numerics/closest_triangle.hpp"

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <span>
#include <vector>

namespace counterpart::attributes {

/// A surface cut open along the seams of an attribute.
class CutSurface {
  public:
    CutSurface(MeshView mesh, const CornerAttribute& attribute, const std::vector<Index>& labels);

    /// The triangles that contain the point: one, those at an edge, or those around a vertex.
    std::vector<Index> around(const SurfacePoint& point) const;
    /// The same point in terms of another triangle that contains it.
    SurfacePoint seen_from(Index triangle, const SurfacePoint& point) const;
    Eigen::Vector3d position(const SurfacePoint& point) const;

    enum class Seams { block, cross };
    /// The triangles within `radius` of `center` that can be reached from `start` through such triangles, in
    /// increasing order; those of `start` always.
    std::vector<Index> reach(std::span<const Index> start, const Eigen::Vector3d& center, double radius,
                             Seams seams) const;
    numerics::ClosestPoint closest_among(std::span<const Index> triangles,
                                         const Eigen::Vector3d& query) const;

  private:
    MeshView mesh_;
    mesh::Fans fans_;
    std::vector<Index> across_;  // [3 t + c]: the next triangle at the edge from corner c, in turn; -1 = none
    std::vector<char> smooth_;   // [3 t + c]: whether there is no seam in between
};

/// Whether two lists in increasing order have an element in common.
bool intersect(std::span<const Index> a, std::span<const Index> b);

}  // namespace counterpart::attributes
