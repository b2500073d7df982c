// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Triangles glued along edges with lengths instead of positions, so that edges can be flipped without
// changing the surface.
#pragma once

#include "base/to_size.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <vector>

namespace counterpart::spectral {

class IntrinsicTriangulation {
  public:
    explicit IntrinsicTriangulation(MeshView mesh);

    /// Adds one constant to every length so that a + b - c >= margin * mean length everywhere.
    void mollify(double margin);
    /// Flips until every glued edge is locally Delaunay; returns the number of flips.
    Index make_delaunay();

    Index n_triangles() const { return static_cast<Index>(vertices_.size() / 3); }
    Index n_cut_edges() const { return n_cut_edges_; }
    /// Half-edge 3 t + i runs from corner i of triangle t to corner i + 1.
    Index origin(Index half_edge) const { return vertices_[to_size(half_edge)]; }
    double length(Index half_edge) const { return lengths_[to_size(half_edge)]; }
    static Index next(Index half_edge) { return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1; }
    double area(Index triangle) const;
    /// Cotangent of the angle opposite to the half-edge.
    double opposite_cotangent(Index half_edge) const;

  private:
    void glue();
    bool is_delaunay(Index half_edge) const;
    std::array<Index, 5> flip(Index half_edge);

    std::vector<Index> vertices_;  // origin of each half-edge
    std::vector<Index> twins_;     // -1 on the boundary
    std::vector<double> lengths_;
    Index n_cut_edges_ = 0;
};

}  // namespace counterpart::spectral
