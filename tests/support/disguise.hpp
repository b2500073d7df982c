// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Ways to make another mesh from a mesh so that the true map is known.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>

namespace counterpart::test {

struct DisguisedMesh {
    TriangleMesh mesh;
    VertexMap mesh_from_original;  ///< the true map
};

/// Vertices, triangles and the corner each triangle starts at in random order; winding kept.
DisguisedMesh shuffled(const TriangleMesh& mesh, std::uint64_t seed);

/// Rotated at random, scaled by a factor in [0.5, 2], translated. No reflection.
TriangleMesh moved(const TriangleMesh& mesh, std::uint64_t seed);

/// In another pose, moved and shuffled.
DisguisedMesh posed(const TriangleMesh& mesh);

/// Every triangle with three vertices of its own: corner c of triangle t is vertex 3 t + c.
TriangleMesh with_separate_triangles(const TriangleMesh& mesh);

/// x -> -x with the winding reversed, so that the outside stays outside.
TriangleMesh mirrored(const TriangleMesh& mesh);

}  // namespace counterpart::test
