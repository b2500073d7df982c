// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// What agrees with itself may yet be in the wrong place: between edits of a regular lattice rows of vertices
/// slide by one, and of two fingers alike one takes the other's place where its own was edited. Such parts
/// are cut off from the rest, and leave vertices over on both sides. Around each part but the largest, and
/// each group of unmatched source vertices, the vertices are put where the motion of the matched ones further
/// out expects them and paired with the closest there; what brings more triangles together replaces the old.
/// `turned`: the surfaces are wound against each other. O(F log F), and for each part the square of its size;
/// leaves parts above 2000 vertices alone.
VertexMap without_dislocations(const TriangleMesh& source, const TriangleMesh& target, VertexMap map,
                               bool turned);

}  // namespace counterpart
