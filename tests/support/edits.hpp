// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Seeded edits of a mesh's connectivity, with what they did.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <set>
#include <vector>

namespace counterpart::test {

struct EditedMesh {
    TriangleMesh mesh;
    std::vector<Index> edited_from_original;  ///< new number of each vertex, -1 for a removed one
    std::set<Index> changed;                  ///< original triangles that the edited mesh has not
};

/// Flips `count` edges, no two of which share a triangle.
EditedMesh with_flipped_edges(const TriangleMesh& mesh, Index count, std::uint64_t seed);
/// Removes one inner vertex and fills the hole by a fan from one of its neighbors.
EditedMesh without_vertex(const TriangleMesh& mesh, std::uint64_t seed);
/// Removes that fraction of the triangles; all vertices stay.
EditedMesh with_missing_triangles(const TriangleMesh& mesh, double fraction, std::uint64_t seed);
/// Removes the island that starts at vertex `first` of a mesh made by joined(): its vertices are the last.
EditedMesh without_last_island(const TriangleMesh& mesh, Index first);
/// Both meshes in one, the second's vertices and triangles after the first's.
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace counterpart::test
