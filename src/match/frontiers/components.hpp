// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::frontiers {

/// A connected component as a mesh of its own.
struct ComponentMesh {
    TriangleMesh mesh;
    std::vector<Index> vertices;  ///< their indices in the whole mesh, increasing
    Adjacency adjacency;
    std::uint64_t signature = 0;  ///< equal for components of the same connectivity, as far as a few rounds
                                  ///< of color refinement can tell
};

/// Largest first, then by signature, then by smallest vertex.
std::vector<ComponentMesh> split_components(MeshView mesh, const Adjacency& adjacency);

/// Components of both meshes with one signature, by their indices in the two lists.
struct ComponentGroup {
    std::vector<std::size_t> source, target;
};
/// Throws InvalidInput naming the first kind of component that the meshes have in different numbers.
std::vector<ComponentGroup> group_components(const std::vector<ComponentMesh>& source,
                                             const std::vector<ComponentMesh>& target);

/// Throws InvalidInput naming the first difference: numbers of vertices, triangles, edges, vertices of a
/// valence.
void require_same_counts(MeshView source, const Adjacency& source_adjacency, MeshView target,
                         const Adjacency& target_adjacency);

}  // namespace counterpart::frontiers
