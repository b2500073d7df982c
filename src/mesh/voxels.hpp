// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <vector>

namespace counterpart::mesh {

/// Cubes of a regular grid, each filled or empty; two layers around all that is filled are empty.
class Voxels {
  public:
    using Cell = std::array<Index, 3>;

    Voxels(const Eigen::RowVector3d& low, double size, const Cell& counts);

    const Cell& counts() const { return counts_; }
    bool at(const Cell& c) const { return filled_[index(c)] != 0; }
    void fill(const Cell& c) { filled_[index(c)] = 1; }
    Eigen::RowVector3d center(const Cell& c) const {
        return low_ + size_ * Eigen::RowVector3d(c[0] + 0.5, c[1] + 0.5, c[2] + 0.5);
    }

    /// Fills gaps of one cell: morphological closing, along the axes. O(cells).
    void close_gaps();
    /// Fills cells until none touch along an edge or in a corner only: then the surface is a manifold
    /// (well-composed, Latecki, Eckhardt, Rosenfeld 1995). O(cells) a round, few rounds.
    void make_manifold();
    /// The faces between filled and empty cells, each two triangles, outward. O(cells).
    TriangleMesh surface() const;

  private:
    std::size_t index(const Cell& c) const {
        return (static_cast<std::size_t>(c[2]) * static_cast<std::size_t>(counts_[1]) +
                static_cast<std::size_t>(c[1])) *
                   static_cast<std::size_t>(counts_[0]) +
               static_cast<std::size_t>(c[0]);
    }
    bool mend_block(const Cell& c);

    Eigen::RowVector3d low_;
    double size_;
    Cell counts_;
    std::vector<char> filled_;
};

/// Filled where the center is inside: where the surface winds around it. O(F * columns of each + cells).
/// Throws InvalidInput for more than 2^27 cells.
Voxels voxels_inside(MeshView closed_mesh, double size);

}  // namespace counterpart::mesh
