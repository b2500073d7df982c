// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/frontier/frontiers.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::frontier {

struct EdgeSplits {
    TriangleMesh mesh;           ///< the vertices of the input keep their indices, new ones follow
    Index n_original = 0;        ///< vertices from this index on are new
    std::vector<Index> per_gap;  ///< new vertices on each edge between frontiers k and k + 1
    bool reached = false;        ///< whether the mesh has f >= sqrt(V) frontiers now
};

/// Splits edges between consecutive frontiers until there are f >= sqrt(V) of them (Sahillioglu and Yemez,
/// section 4.2), so that a frontier has sqrt(V) vertices on average. All edges between two consecutive
/// frontiers are split in the same way, starting with the fewest edges, in rounds: the result depends only on
/// the connectivity, so two meshes of the same connectivity and corresponding sources keep the same
/// connectivity. (Triangles are split along their orientation, which must agree too.) Gives up, with
/// `reached` false, when the mesh would grow to more than `max_growth` times its vertices. Only the component
/// of the source is split. O(new V).
EdgeSplits split_edges_for_depth(MeshView mesh, const Frontiers& frontiers, double max_growth = 8);

}  // namespace counterpart::frontier
