// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/message.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart {

struct DifferencesOptions {
    int n_threads = 0;    ///< 0: all that the machine has. The result does not depend on it
    Progress progress{};  ///< called between steps; may stop the search
};

/// One place where two meshes differ: triangles that touch each other and have no counterpart.
struct Edit {
    std::vector<Index> source_triangles, target_triangles;  ///< without a counterpart
    std::vector<Index> source_vertices, target_vertices;    ///< likewise
    std::string sentence;                                   ///< what seems to have happened
};

struct MeshDifferences {
    /// Of the part that the meshes share; the rest is unmatched.
    VertexMap target_from_source;
    /// Shares of the vertices of each mesh that are matched, in [0, 1].
    double source_share = 0, target_share = 0;
    /// Matched source vertices to doubt: fewer than two of their triangles, or less than half, have a
    /// counterpart, so that place alone decided; or they are untold.
    std::vector<Index> uncertain;
    /// Matched source vertices in regular patches (grids, lattices) that touch what differs and of which
    /// lengths do not say that they are the same.
    std::vector<Index> untold;
    /// Without a counterpart, in increasing order.
    std::vector<Index> source_vertices, target_vertices, source_triangles, target_triangles;
    std::vector<Edit> edits;  ///< the same, place by place
    Index n_matched_triangles = 0;
    Index largest_region = 0;       ///< matched triangles in the largest region that edges connect
    bool winding_reversed = false;  ///< the target is wound against the source
    /// In [0, 1]: how well edge lengths confirm what is shared. 1: they are equal but for a common factor; 0:
    /// they deviate as much as where a mesh is laid on itself at random.
    double agreement = 0;
    /// Another way to match the meshes had nearly as much evidence: then every vertex is uncertain.
    bool is_ambiguous = false;
    std::string summary;            ///< one sentence
    std::vector<Message> messages;  ///< where to doubt it
};

/// Finds what two meshes of nearly the same connectivity share, and names where they differ.
///
/// Components that are equal in both are matched as by match_exact. In the rest, regions grow from pairs of
/// half-edges whose color (valences within 1 to 8 edges) is unique in both meshes, by evidence: triangles
/// that propose a pair of vertices, weighted by how well they agree in shape, and equal colors. A region is
/// kept if it agrees in place with those around it, or far beyond what chance gives on these meshes with
/// itself, in valences and in edge lengths, which have a veto. Then unmatched vertices
/// take the vertex that lies where their matched neighbors expect it. So a local edit costs its surroundings
/// at most, and unrelated meshes share nothing. No pose is assumed. O(F log F); the part that differs costs
/// most. Throws InvalidInput for invalid meshes or options, and Canceled.
MeshDifferences find_differences(MeshView source, MeshView target, const DifferencesOptions& options = {});

}  // namespace counterpart
