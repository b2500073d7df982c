// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

struct OrientResult {
    TriangleMesh mesh;            ///< the same vertices and triangles, some with the last two corners swapped
    Index n_disagreeing = 0;      ///< triangles that were wound against the larger part of their piece
    Index n_one_sided = 0;        ///< pieces that cannot be wound consistently, as a Moebius band
    bool was_inside_out = false;  ///< whether most of the area then enclosed a negative volume and was turned
};

/// Winds all triangles consistently, and outwards. Pieces are triangles joined across edges with exactly two
/// of them. In each the triangles of less number are turned to agree with the others; then every closed piece
/// is turned that encloses a negative volume, and so are all open ones together. A flat mesh has no outside:
/// its winding is kept. Degenerate triangles stay as they are. O(F log valence). Throws InvalidInput for an
/// invalid mesh.
OrientResult orient(const TriangleMesh& mesh);

}  // namespace counterpart
