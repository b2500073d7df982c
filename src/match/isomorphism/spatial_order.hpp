// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A numbering in which what is close in space is close in memory.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::isomorphism {

/// A mesh's triangles, renumbered.
struct SpatialOrder {
    std::vector<Index> corner;          ///< vertex at each corner 3 t + c, both in the new numbering
    std::vector<Index> input_triangle;  ///< the mesh's number of each triangle
    std::vector<Index> input_vertex;    ///< the mesh's number of each vertex
};

/// Vertices along a Morton curve through their positions, triangles by blocks of it. Only
/// speed depends on the positions. O(V + F), by radix sort.
SpatialOrder make_spatial_order(MeshView mesh);

}  // namespace counterpart::isomorphism
