// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart::test {

/// A mesh with its layout of texture coordinates.
struct LaidOut {
    TriangleMesh mesh;
    CornerAttribute uv;
    std::vector<Index> original_from_mesh{};  ///< vertices; empty: itself
};

/// The figure of make_character: two charts and a seam, which lie over themselves where limbs hide others.
LaidOut laid_out_character();
/// A blob in two charts that lie over nothing, with a seam around it.
LaidOut laid_out_ball();
/// The same surface and layout in other triangles and another order of vertices: fewer ones, but for seams.
LaidOut retriangulated(const LaidOut& original, std::uint64_t seed);
/// A square of cells in the plane with its places as texture coordinates, cut along random diagonals.
LaidOut laid_out_square(int cells, std::uint64_t seed);
/// One beside the other.
LaidOut joined(const LaidOut& a, const LaidOut& b);

}  // namespace counterpart::test
