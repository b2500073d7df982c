// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Ways to make another mesh from a mesh so that the true map is known.
#pragma once

#include <counterpart/mesh/attributed_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

struct ShuffleResult {
    TriangleMesh mesh;
    std::vector<Index> shuffled_from_original;  ///< the true map: new number of each old vertex
    Triangles original_corner_from_shuffled;    ///< for each new corner its old one, 3 * triangle + corner
};

/// The same surface with its vertices, its triangles and the corner each triangle starts at in random order;
/// winding kept. O(V + F).
ShuffleResult shuffle(const TriangleMesh& mesh, std::uint64_t seed);

struct AttributedShuffleResult {
    AttributedMesh content;
    std::vector<Index> shuffled_from_original;  ///< of the vertices
};

/// The same with all that is attached. Values per corner are in random order too. O(n).
AttributedShuffleResult shuffle(const AttributedMesh& content, std::uint64_t seed);

/// Rotated at random, scaled by a factor in [0.5, 2], moved by up to three units of the mesh along each axis.
/// No reflection. O(V).
TriangleMesh move_at_random(const TriangleMesh& mesh, std::uint64_t seed);

}  // namespace counterpart
