// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <span>
#include <vector>

namespace counterpart::io {

inline Index n_faces(MeshView mesh) {
    return mesh.polygons == nullptr ? mesh.n_triangles() : mesh.polygons->count();
}

/// Calls body(triangle, corners) for each polygon, or for each triangle where there are none: its first
/// triangle, and its corners as those of triangles, 3 * triangle + corner.
template <class Body>
void for_each_face(MeshView mesh, const Body& body) {
    if (mesh.polygons == nullptr) {
        for (Index t = 0; t < mesh.n_triangles(); ++t)
            body(t, std::span<const Index>(std::array{3 * t, 3 * t + 1, 3 * t + 2}));
        return;
    }
    const std::vector<Index> corners = mesh.polygons->triangle_corners();
    for (Index p = 0; p < mesh.polygons->count(); ++p)
        body(mesh.polygons->first_triangle(p),
             std::span(corners).subspan(
                 static_cast<std::size_t>(mesh.polygons->first[static_cast<std::size_t>(p)]),
                 static_cast<std::size_t>(mesh.polygons->size(p))));
}

}  // namespace counterpart::io
