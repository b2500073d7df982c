// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/surface/openness.hpp"

#include "mesh/edge_table.hpp"

#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/weld.hpp>

#include <cmath>

namespace counterpart::surface_match {

double openness(MeshView mesh) {
    const TriangleMesh welded = weld(mesh).mesh;
    double length = 0;
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(welded)))
        length += (welded.vertices.row(v) - welded.vertices.row(w)).norm();
    return length / std::sqrt(surface_area(mesh));
}

}  // namespace counterpart::surface_match
