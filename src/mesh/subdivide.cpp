// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "mesh/edge_table.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/mesh/shapes.hpp>

#include <limits>

namespace counterpart {

TriangleMesh subdivide(MeshView mesh) {
    require_valid(mesh);
    if (mesh.n_triangles() > std::numeric_limits<Index>::max() / 4 - mesh.n_vertices() / 4)
        throw InvalidInput("subdivide: the mesh is too large to subdivide again");
    const mesh::EdgeTable edges(mesh);
    TriangleMesh fine;
    fine.vertices.resize(mesh.n_vertices() + edges.n_edges(), 3);
    fine.vertices.topRows(mesh.n_vertices()) = mesh.vertices;
    Triangles middles = Triangles::Constant(mesh.n_triangles(), 3, -1);  // of the edge behind each corner
    for (Index e = 0; e < edges.n_edges(); ++e) {
        const Index middle = mesh.n_vertices() + e;
        fine.vertices.row(middle) =
            0.5 * mesh.vertices.row(edges.low(e)) + 0.5 * mesh.vertices.row(edges.high(e));
        for (const mesh::EdgeTable::HalfEdge& side : edges.half_edges(e))
            middles(side.triangle, side.corner) = middle;
    }
    fine.triangles.resize(4 * mesh.n_triangles(), 3);
    Index n = 0;
    for (Index t = 0; t < mesh.n_triangles(); ++t) {
        if (mesh::is_degenerate(mesh, t)) continue;
        const Index ab = middles(t, 0), bc = middles(t, 1), ca = middles(t, 2);
        fine.triangles.row(n++) << mesh.triangles(t, 0), ab, ca;
        fine.triangles.row(n++) << mesh.triangles(t, 1), bc, ab;
        fine.triangles.row(n++) << mesh.triangles(t, 2), ca, bc;
        fine.triangles.row(n++) << ab, bc, ca;
    }
    fine.triangles.conservativeResize(n, 3);
    return fine;
}

}  // namespace counterpart
