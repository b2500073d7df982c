// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/tetrahedral_mesh.hpp>

#include <optional>

namespace counterpart::mesh {

/// A vertex that lies within a face or an edge of a tetrahedron of which it is no corner.
struct HangingVertex {
    Index vertex = -1, tetrahedron = -1;
};

/// The first one, by tetrahedra: there neighbors do not share a face, and the solid is open. Only vertices
/// that are connected with the tetrahedron count; bodies that merely touch may do so anywhere. The mesh must
/// be valid. About O(T), by a tree of the vertices on the boundary.
std::optional<HangingVertex> find_hanging_vertex(const TetrahedralMesh& mesh);

}  // namespace counterpart::mesh
