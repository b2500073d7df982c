// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes whose vertices lie at the same places, whatever triangles they are joined to.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>

namespace counterpart::place {

struct SamePlaces {
    VertexMap target_from_source;  ///< isolated vertices may be unmatched
    Index n_same_faces = 0;        ///< source triangles that go to a target triangle
    bool is_reversed = false;      ///< most edges of triangles run the other way in the target
};

/// Where every vertex of a triangle lies, but for rounding, at the place of one of the other mesh, in both
/// directions, and at least two fifths of the edges of both are edges of the other: as they are of any two
/// triangulations of quads, pentagons and hexagons. Of several vertices at one place that is taken of which
/// most edges are the same, each by one only while there are enough. Nothing otherwise, which is seen from a
/// few vertices mostly. O(V log V + F).
std::optional<SamePlaces> find_same_places(MeshView source, MeshView target);

/// Whether every triangle of a mesh without polygons lies inside a polygon of the other, or, where both have
/// some, each polygon goes to one. (Of the vertices: several triangles may cover a polygon twice.)
bool keeps_polygons(MeshView source, MeshView target, const VertexMap& target_from_source);

/// For every corner of the source's triangles, 3 * triangle + corner of the target, at the image of its
/// vertex: in the triangle that most of the corner's own triangle goes to. -1 for unmatched vertices.
Triangles corners_by_vertices(MeshView source, MeshView target, const VertexMap& target_from_source);

}  // namespace counterpart::place
