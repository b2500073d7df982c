// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A mesh in its texture.
#pragma once

#include "numerics/closest_triangle.hpp"

#include <counterpart/mesh/attributed_mesh.hpp>

#include <vector>

namespace counterpart::uv {

/// A vertex with one of the texture coordinates that it has in a chart. A chart: triangles that are joined in
/// the layout and face one way in it.
struct Corner {
    Index chart, vertex, row;
    auto operator<=>(const Corner&) const = default;
};

class Layout {
  public:
    /// Both must outlive it. Triangles without texture coordinates, or without area there, are in no chart.
    /// Throws InvalidInput naming `whose`. O(F log F).
    Layout(MeshView mesh, const CornerAttribute& coordinates, const char* whose);

    MeshView mesh() const { return mesh_; }
    const std::vector<Corner>& corners() const { return corners_; }  ///< in increasing order, each once
    Eigen::Vector3d at(Index row) const {
        return {coordinates_.values(row, 0), coordinates_.values(row, 1), 0};
    }
    /// The way that a corner's chart faces, as a unit normal.
    Eigen::Vector3d facing(const Corner& corner) const {
        return facing_[static_cast<std::size_t>(corner.chart)];
    }
    double size() const { return size_; }                ///< the square root of the charts' area
    double edge_length() const { return edge_length_; }  ///< the mean one

    /// The charts' triangles in the plane; `triangle` gives their numbers in the mesh, `chart` their charts.
    const numerics::ClosestTriangle& plane() const { return plane_; }
    Index triangle(Index in_plane) const { return triangles_[static_cast<std::size_t>(in_plane)]; }
    Index chart(Index in_plane) const { return charts_[static_cast<std::size_t>(in_plane)]; }

  private:
    MeshView mesh_;
    const CornerAttribute& coordinates_;
    std::vector<Corner> corners_;
    std::vector<Eigen::Vector3d> facing_;    // by charts
    std::vector<Index> triangles_, charts_;  // of those in the plane
    double size_ = 0, edge_length_ = 0;
    numerics::ClosestTriangle plane_;
};

}  // namespace counterpart::uv
