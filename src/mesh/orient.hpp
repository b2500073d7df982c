// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::mesh {

struct OrientResult {
    TriangleMesh mesh;        ///< the same vertices and triangles, some with the last two corners swapped
    Index n_disagreeing = 0;  ///< triangles flipped to agree with the majority of their component
    Index n_one_sided = 0;    ///< non-orientable components, such as a Moebius strip
    bool was_inside_out =
        false;  ///< whether most of the area then enclosed a negative volume and was flipped
};

/// Orients all triangles consistently, and outward. Components here are joined across edges with exactly two
/// triangles. In each, the minority is flipped to agree with the majority; then every closed component that
/// encloses a negative volume is flipped, and all open components together if they do. A flat mesh has no
/// outside: its orientation is kept. Degenerate triangles stay as they are. O(F log valence). Throws
/// InvalidInput for an invalid mesh.
OrientResult orient(MeshView mesh);

}  // namespace counterpart::mesh
