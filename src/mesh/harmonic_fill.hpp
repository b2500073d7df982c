// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/adjacency.hpp>

#include <vector>

namespace counterpart::mesh {

struct FillResult {
    Matrix values;
    Index filled = 0;   ///< rows filled from their neighbors
    Index unknown = 0;  ///< rows left NaN: no vertex of their component has a value
};

/// Replaces the rows of `values` (n_vertices x K) that contain NaN by the harmonic extension of the others on
/// the graph: each becomes the mean of its neighbors, so no value leaves the range of those around it.
/// O(n^1.5) for n unknown rows.
FillResult fill_from_neighbors(const Adjacency& adjacency, const Matrix& values);

/// The same, and rows of components without any value are copied from the nearest vertex, in space, that has
/// one: `unknown` counts them. Throws InvalidInput if no row has values.
FillResult fill_everywhere(MeshView mesh, const Matrix& values);

}  // namespace counterpart::mesh
