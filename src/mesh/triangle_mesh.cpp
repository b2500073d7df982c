// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <limits>

#include <fmt/format.h>

namespace counterpart {

void require_valid(MeshView mesh) {
    if (mesh.vertices.rows() == 0) throw InvalidInput("the mesh has no vertices");
    if (mesh.vertices.rows() > std::numeric_limits<Index>::max())
        throw InvalidInput(
            fmt::format("the mesh has {} vertices; at most {} are supported: decimate it first",
                        mesh.vertices.rows(), std::numeric_limits<Index>::max()));
    if (mesh.triangles.rows() == 0)
        throw InvalidInput("the mesh has no faces: a point cloud cannot be matched as a surface");
    if (mesh.triangles.rows() > max_triangles) {
        throw InvalidInput(
            fmt::format("the mesh has {} triangles; at most {} are supported: decimate it first",
                        mesh.triangles.rows(), max_triangles));
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        if (!mesh.vertices.row(v).allFinite()) {
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite ({}, {}, {})", v,
                                           mesh.vertices(v, 0), mesh.vertices(v, 1), mesh.vertices(v, 2)));
        }
    }
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const Index v = mesh.triangles(t, corner);
            if (v < 0 || v >= mesh.n_vertices()) {
                throw InvalidInput(fmt::format("triangle {} names vertex {}, but vertices run from 0 to {}",
                                               t, v, mesh.n_vertices() - 1));
            }
        }
    }
    if (mesh.polygons != nullptr) mesh::require_valid_polygons(mesh);
}

}  // namespace counterpart
