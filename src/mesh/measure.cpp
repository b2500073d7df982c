// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/measure.hpp>

#include <Eigen/Geometry>

namespace counterpart {
namespace {

Eigen::Vector3d corner(MeshView mesh, Index triangle, int which) {
    return mesh.vertices.row(mesh.triangles(triangle, which)).transpose();
}

// Twice the triangle's area, along its normal.
Eigen::Vector3d area_vector(MeshView mesh, Index t) {
    const Eigen::Vector3d a = corner(mesh, t, 0);
    return (corner(mesh, t, 1) - a).cross(corner(mesh, t, 2) - a);
}

}  // namespace

Vector triangle_areas(MeshView mesh) {
    Vector areas(mesh.n_triangles());
    for (Index t = 0; t < mesh.n_triangles(); ++t) areas[t] = 0.5 * area_vector(mesh, t).norm();
    return areas;
}

double surface_area(MeshView mesh) { return triangle_areas(mesh).sum(); }

Vector vertex_areas(MeshView mesh) {
    Vector areas = Vector::Zero(mesh.n_vertices());
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const double third = area_vector(mesh, t).norm() / 6;
        for (int c = 0; c < 3; ++c) areas[mesh.triangles(t, c)] += third;
    }
    return areas;
}

Points triangle_normals(MeshView mesh) {
    Points normals(mesh.n_triangles(), 3);
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        normals.row(t) = area_vector(mesh, t).stableNormalized().transpose();
    return normals;
}

Points vertex_normals(MeshView mesh) {
    Points normals = Points::Zero(mesh.n_vertices(), 3);
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        const Eigen::RowVector3d normal = area_vector(mesh, t).transpose();
        for (int c = 0; c < 3; ++c) normals.row(mesh.triangles(t, c)) += normal;
    }
    for (Index v = 0; v < mesh.n_vertices(); ++v) {
        const Eigen::RowVector3d normal = normals.row(v);
        normals.row(v) = normal.stableNormalized();
    }
    return normals;
}

double mean_edge_length(MeshView mesh) {
    const Adjacency adjacency(mesh);
    double sum = 0;
    for (Index v = 0; v < mesh.n_vertices(); ++v)
        for (const Index w : adjacency.neighbors(v))
            if (v < w) sum += (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
    return adjacency.n_edges() > 0 ? sum / adjacency.n_edges() : 0;
}

double signed_volume(MeshView mesh) {
    // Relative to a vertex, so that meshes far from the origin lose no digits.
    const Eigen::Vector3d origin =
        mesh.n_vertices() > 0 ? Eigen::Vector3d(mesh.vertices.row(0)) : Eigen::Vector3d::Zero();
    double six_volumes = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        six_volumes += area_vector(mesh, t).dot(corner(mesh, t, 0) - origin);
    return six_volumes / 6;
}

Eigen::Vector3d surface_centroid(MeshView mesh) {
    const Vector areas = vertex_areas(mesh);
    const double total = areas.sum();
    if (total > 0) return (mesh.vertices.transpose() * areas) / total;
    return mesh.vertices.colwise().mean().transpose();
}

}  // namespace counterpart
