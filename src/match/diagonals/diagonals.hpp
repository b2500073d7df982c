// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes of triangles that are the same but for the diagonals along which their quads were cut.
#pragma once

#include "match/diagonals/with_quads.hpp"

#include <counterpart/base/progress.hpp>
#include <counterpart/map/vertex_map.hpp>

#include <optional>
#include <string>

namespace counterpart::diagonals {

struct Recut {
    WithQuads source, target;
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

/// Both meshes with all quads of one that has polygons, taken to the other by an isomorphism that keeps them.
/// The walk pairs a part that is alike in itself in one of its ways, and the quads that this cuts differently
/// allow no other; all quads allow them all. Nothing where neither has polygons, or some of more than four
/// corners. O(F).
std::optional<Recut> with_known_quads(MeshView source, MeshView target, const VertexMap& target_from_source);

}  // namespace counterpart::diagonals
