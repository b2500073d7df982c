// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/geodesic/distance_graph.hpp>

#include <vector>

namespace counterpart {

/// Sampling ends as soon as one of the two bounds is met; at least one must be given.
struct BaseVertexOptions {
    Index count = 0;  ///< at most this many; 0 = no bound
    double radius =
        0;  ///< until no reachable vertex is farther than this from its base, mesh units; 0 = no bound
    Index first = -1;  ///< where to begin; -1 = the vertex farthest from the centre of the surface
    Progress progress{};
};

/// A uniform sample of a mesh's vertices, and the patches of vertices nearest to each.
struct BaseVertices {
    std::vector<Index> vertices;  ///< in the order they were taken: each prefix is a coarser sample
    /// For each vertex of the mesh the number (0 .. vertices.size() - 1) of its nearest base, the earlier one
    /// of equally near ones; -1 in a component that got none.
    std::vector<Index> base_of_vertex;
    Vector distance_to_base;  ///< per vertex; infinite in a component that got none
    /// Greatest distance from a vertex to its base, over the components that have one.
    double covering_radius = 0;
};

/// Farthest-point sampling by graph distances, which spreads bases as uniformly as the base vertices of
/// Hilaga et al. 2001: begin anywhere, then always take the vertex farthest from all taken; ties by vertex
/// number. Components without a base come first, the one with the most vertices before the others, each
/// beginning at its vertex farthest from the centre of the surface. Bases are then more than `radius` apart
/// and cover the mesh within it.
///
/// A new base only searches the region it takes over: O(V log count) for the searches, O(V count) for the
/// choice. Throws InvalidInput for a graph of another mesh, no bound, a negative one, or a `first` that is
/// not a vertex.
BaseVertices base_vertices(const TriangleMesh& mesh, const DistanceGraph& graph,
                           const BaseVertexOptions& options);

}  // namespace counterpart
