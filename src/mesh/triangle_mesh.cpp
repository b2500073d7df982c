// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/polygons.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <limits>

#include <fmt/format.h>

namespace counterpart {
namespace {

void require_unused(MeshView mesh) {
    std::vector<char> is_left_out;
    for (const Index v : mesh.left_out) {
        if (v < 0 || v >= mesh.n_vertices())
            throw InvalidInput(fmt::format("vertex {} is said to be left out, but there is none", v));
        is_left_out.resize(static_cast<std::size_t>(mesh.n_vertices()), 0);
        is_left_out[static_cast<std::size_t>(v)] = 1;
    }
    for (Eigen::Index i = 0; !is_left_out.empty() && i < mesh.triangles.size(); ++i)
        if (is_left_out[static_cast<std::size_t>(mesh.triangles.data()[i])] != 0)
            throw InvalidInput(fmt::format("triangle {} names vertex {}, which is left out", i / 3,
                                           mesh.triangles.data()[i]));
}

}  // namespace

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
    require_unused(mesh);
}

}  // namespace counterpart
