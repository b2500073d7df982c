// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <array>
#include <vector>

namespace counterpart::diagonals {

/// A mesh with some pairs of its triangles made one quad; the others are polygons of three corners.
struct WithQuads {
    TriangleMesh mesh;
    std::vector<Index> triangle;  ///< that each of its triangles is in the mesh it was made of
};

/// The vertices around the quad of two triangles that share an edge, in the direction of `t`: the tip of `t`,
/// an end of the diagonal, the tip of `u`, the other end.
std::array<Index, 4> around_quad(TrianglesView triangles, Index t, Index u);

/// `quads`: two triangles each that share an edge. Triangles that are in none come first.
WithQuads with_quads(MeshView mesh, const std::vector<std::array<Index, 2>>& quads);

}  // namespace counterpart::diagonals
