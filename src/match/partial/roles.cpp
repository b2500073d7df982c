// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/roles.hpp"

#include "mesh/edge_table.hpp"

#include <counterpart/mesh/measure.hpp>

#include <cmath>

namespace counterpart::partial_match {

double openness(MeshView mesh) {
    double length = 0;
    for (const auto& [v, w] : mesh::boundary_edges(mesh::EdgeTable(mesh)))
        length += (mesh.vertices.row(v) - mesh.vertices.row(w)).norm();
    return length / std::sqrt(surface_area(mesh));
}

Part seen_part(MeshView source, MeshView target) {
    const bool a = openness(source) > open_part, b = openness(target) > open_part;
    if (a && b) return Part::both;
    if (a) return Part::source;
    return b ? Part::target : Part::neither;
}

}  // namespace counterpart::partial_match
