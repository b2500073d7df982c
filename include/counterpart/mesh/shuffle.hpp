// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Derived meshes whose true map is known: test data for matching.
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

struct ShuffleResult {
    TriangleMesh mesh;
    std::vector<Index> shuffled_from_original;  ///< the true map: new index of each old vertex
    Triangles original_corner_from_shuffled;    ///< for each new corner the old one, 3 * triangle + corner
};

/// The same surface with its vertices, triangles, and the first corner of each triangle in random order.
/// Preserves orientation. A mesh of polygons gets these in random order and from other first corners on, and
/// so mostly cut along other diagonals. O(V + F).
ShuffleResult shuffle(MeshView mesh, std::uint64_t seed);

struct AttributedShuffleResult {
    AttributedMesh content;
    std::vector<Index> shuffled_from_original;  ///< of the vertices
};

/// The same with attributes, whose rows are shuffled too. O(n).
AttributedShuffleResult shuffle(const AttributedMesh& content, std::uint64_t seed);

/// Applies a random rotation, a scale in [0.5, 2] and a translation by up to three mesh units along each
/// axis. No reflection. O(V).
TriangleMesh move_at_random(MeshView mesh, std::uint64_t seed);

}  // namespace counterpart
