// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>

namespace counterpart::mesh {

/// Throws InvalidInput naming the first polygon that does not fit the mesh's triangles. O(F).
void require_valid_polygons(MeshView whole);

/// The mesh with a vertex in the middle of each of its polygons, joined to the polygon's corners, in place of
/// their triangles: polygons are equal, wherever they begin and however they were cut, if these triangles
/// are. Triangle j is that of polygon corner j: its vertex, that of the next corner, the polygon's middle.
/// The middle of polygon p is vertex n_vertices + p. The mesh must have polygons. O(corners).
TriangleMesh coned(MeshView whole);

/// What numbers of polygons and of their corners differ, as a sentence; empty if none does. O(n log n).
std::string first_difference(const Polygons& source, const Polygons& target);

}  // namespace counterpart::mesh
