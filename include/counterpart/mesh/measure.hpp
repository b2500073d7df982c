// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Sum of the triangles' areas, in squared mesh units.
double surface_area(MeshView mesh);
/// Area of each triangle.
Vector triangle_areas(MeshView mesh);
/// Area of each vertex: a third of the area of its triangles. Sums to surface_area.
Vector vertex_areas(MeshView mesh);
/// Unit normal of each triangle; zero for a degenerate one.
Points triangle_normals(MeshView mesh);
/// Area-weighted average of the normals of the triangles around each vertex, unit length; zero where
/// undefined.
Points vertex_normals(MeshView mesh);
/// Mean length of the undirected edges. O(V + F).
double mean_edge_length(MeshView mesh);
/// Enclosed volume by the divergence theorem: positive for a closed mesh whose triangles are
/// counter-clockwise seen from outside.
double signed_volume(MeshView mesh);
/// Area-weighted mean of the triangles' centers.
Eigen::Vector3d surface_centroid(MeshView mesh);

}  // namespace counterpart
