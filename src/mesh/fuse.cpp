// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/edge_table.hpp"
#include "mesh/voxels.hpp"
#include "numerics/closest_triangle.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/variants.hpp>

#include <cmath>

#include <fmt/format.h>

namespace counterpart {
namespace {

// Halfway to the mean of their neighbors.
void smooth(TriangleMesh& mesh, const Adjacency& adjacency) {
    const Points before = mesh.vertices;
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        const auto neighbors = adjacency.neighbors(v);
        for (const Index w : neighbors) sum += before.row(w);
        mesh.vertices.row(v) = 0.5 * (before.row(v) + sum / static_cast<double>(neighbors.size()));
    }
}

// Steps of cubes become a surface close to the original one; bridges stay smooth.
void draw_to(const numerics::ClosestTriangle& original, double cell, TriangleMesh& mesh) {
    const Adjacency adjacency(mesh);
    for (int round = 0; round < 3; ++round) {
        smooth(mesh, adjacency);
        const Points normals = vertex_normals(mesh);
        for (Index v = 0; v < mesh.n_vertices(); ++v) {
            const auto found =
                original.closest(mesh.vertices.row(v).transpose(), normals.row(v).transpose(), 0.5, cell);
            if (found.triangle >= 0)
                mesh.vertices.row(v) = 0.5 * (mesh.vertices.row(v) + original.position(found).transpose());
        }
    }
}

std::vector<Index> nearest_alike(MeshView from, MeshView to, double radius) {
    const Points from_normals = vertex_normals(from), to_normals = vertex_normals(to);
    const numerics::OrientedNeighbors neighbors(to.vertices, to_normals, radius);
    std::vector<Index> image;
    for (Index v = 0; v < from.n_vertices(); ++v) {
        const Index w = neighbors.closest(from.vertices.row(v), from_normals.row(v));
        const bool is_near = (from.vertices.row(v) - to.vertices.row(w)).norm() <= radius &&
                             from_normals.row(v).dot(to_normals.row(w)) > 0;
        image.push_back(is_near ? w : -1);
    }
    return image;
}

}  // namespace

FusedMesh fuse(MeshView mesh, double cell) {
    require_valid(mesh);
    if (!(cell > 0 && std::isfinite(cell)))
        throw InvalidInput(fmt::format("the size of a cell must be positive and finite, not {}", cell));
    if (!mesh::boundary_edges(mesh::EdgeTable(mesh)).empty())
        throw UnsuitableMesh("the mesh is not closed: what is inside of it is not defined");
    mesh::Voxels voxels = mesh::voxels_inside(mesh, cell);
    voxels.close_gaps();
    voxels.make_manifold();
    FusedMesh fused{voxels.surface(), {}};
    if (fused.mesh.n_triangles() == 0)
        throw UnsuitableMesh(fmt::format("no cell of size {} lies inside the mesh: take smaller ones", cell));
    draw_to(numerics::ClosestTriangle(mesh.vertices, mesh.triangles), cell, fused.mesh);
    fused.fused_from_original = nearest_alike(mesh, fused.mesh, 1.5 * cell);
    return fused;
}

}  // namespace counterpart
