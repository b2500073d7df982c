// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// One place where two meshes differ: triangles that touch each other and have no counterpart.
struct Edit {
    std::vector<Index> source_triangles, target_triangles;  ///< without a counterpart
    std::vector<Index> source_vertices, target_vertices;    ///< likewise
    std::string sentence;                                   ///< what seems to have happened
};

struct MeshDifference {
    /// Of the part that the meshes share; the rest is unmatched.
    VertexMap target_from_source;
    /// Matched source vertices to doubt: fewer than two of their triangles, or less than half, have a
    /// counterpart.
    std::vector<Index> uncertain;
    /// Without a counterpart, in increasing order.
    std::vector<Index> source_vertices, target_vertices, source_triangles, target_triangles;
    std::vector<Edit> edits;  ///< the same, place by place
    Index n_matched_triangles = 0;
    Index largest_part = 0;  ///< triangles of the largest matched part that is connected through edges
    std::string summary;     ///< one sentence
};

/// Finds what two meshes of nearly the same connectivity share, and names where they differ.
///
/// Grows from pairs of half-edges whose colour (valences within three steps) is unique in both meshes. A
/// vertex pair is proposed by every edge whose ends are matched already, and the pairs are accepted in the
/// order of their evidence: triangles that propose them, weighted by how well these agree in shape, and equal
/// colours. A seed counts only if what grows from it agrees far beyond chance. So a local edit costs its
/// surroundings at most. Connectivity decides, geometry only weighs; no pose is assumed. O(F log F). Throws
/// InvalidInput for invalid meshes.
MeshDifference find_differences(const TriangleMesh& source, const TriangleMesh& target);

}  // namespace counterpart
