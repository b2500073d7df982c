// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What growing over edges leaves: faces that hang on the matched part by vertices only, and edits that
// connectivity can explain in more than one way.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Adds to `map`, where a matched vertex or edge has exactly one unmatched face on either side, the vertices
/// of that face; `turned` if the surfaces are wound against each other. Repeats while it finds some. O(F)
/// each time.
VertexMap with_hanging_faces(const TriangleMesh& source, const TriangleMesh& target, VertexMap map,
                             bool turned);

/// Where a vertex is unmatched, one of its neighbours may have taken its partner, and two neighbours that
/// lost triangles may have each other's: connectivity often explains an edit in several ways. The way that
/// more triangles of agreeing edge lengths support is kept. O(F log F).
VertexMap with_better_shape(const TriangleMesh& source, const TriangleMesh& target, VertexMap map);

}  // namespace counterpart
