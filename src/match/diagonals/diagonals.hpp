// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes of triangles that are the same but for the diagonals along which their quads were cut.
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <optional>
#include <string>
#include <vector>

namespace counterpart::diagonals {

/// A mesh with some pairs of its triangles made one quad; the others are polygons of three corners.
struct WithQuads {
    TriangleMesh mesh;
    std::vector<Index> triangle;  ///< that each of its triangles is in the mesh it was made of
};
struct Recut {
    WithQuads source, target;
    Index n_quads = 0;
};

struct RecutSearch {
    std::optional<Recut> found;
    std::string why_not;  ///< the end of a sentence; empty where the meshes were not compared
};

/// Both meshes with the quads that one cuts along one diagonal and the other along the other; nothing if they
/// differ otherwise, or not at all. The caller checks that what is found is an isomorphism.
///
/// Where a mesh has polygons, only edges inside these may differ. Where none has, those may along which two
/// triangles of either make a convex quad that is bent by less than 60 degrees; and meshes where most
/// neighborhoods are equal are not compared: they were edited, not cut anew. Nor are non-manifold meshes.
///
/// A walk begins at an edge that is no diagonal: at a border, or the sharpest one of a component. It is tried
/// from every edge of the target, a few steps from most, the whole way from at most 16: about O(F).
RecutSearch find_recut_quads(MeshView source, MeshView target, const Progress& progress);

}  // namespace counterpart::diagonals
