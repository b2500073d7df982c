// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress_range.hpp"

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::surface_match {

/// A coarse copy of a large surface, on which maps are sought.
struct Proxy {
    TriangleMesh mesh;                 // some of the full surface's vertices, evenly spread
    std::vector<Index> full_of_proxy;  // which ones
    std::vector<Index> cell_of_full;   // the proxy's vertex nearest to each vertex of the full surface
};

/// The dual of the geodesic Voronoi cells of farthest-point samples: a triangle where three cells meet. Its
/// vertices are even, its triangles oriented as those around them; it may lack what is thinner than a cell.
/// About O(V log n_vertices).
Proxy make_proxy(MeshView full, Index n_vertices, const ProgressRange& progress = {});

}  // namespace counterpart::surface_match
