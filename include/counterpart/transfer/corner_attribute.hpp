// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/transfer/coverage.hpp>

#include <vector>

namespace counterpart {

struct CarryCornersOptions {
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};

struct CarriedCorners {
    CornerAttribute attribute;              ///< of the target's triangles
    std::vector<Index> source_from_target;  ///< for each target triangle the source triangle it belongs to
    Coverage coverage;                      ///< of the target's vertices
    Index seam_triangles = 0;               ///< target triangles with an edge on a seam
    Index moved_vertices = 0;               ///< target vertices moved onto a seam, for this attribute only
    double largest_move = 0;                ///< how far, on the source, in its units
    Index without_triangles = 0;  ///< target triangles that got nothing, as the source has nothing there
};

/// Texture coordinates or colours for the target's corners, interpolated on the source. Where they jump from
/// one source triangle to the next (by more than 1e-6 of their range) there is a seam; where `labels` of
/// source triangles (materials; empty = none) differ too.
///
/// No target triangle crosses a seam. Along each target edge that does, the end that is nearer to the seam is
/// moved onto it, so that both sides meet there; each triangle then lies on one side and takes its three
/// values from there. Where the map is a vertex permutation of one connectivity, values come back bit by bit.
/// Unmatched vertices are placed by complete_map. Values that agree at a vertex share a row. Throws
/// InvalidInput if the map, the attribute or the labels do not fit. O(F log F) for meshes of like resolution.
CarriedCorners carry_corners(const SurfaceMap& source_from_target, const TriangleMesh& source,
                             const TriangleMesh& target, const CornerAttribute& attribute,
                             const std::vector<Index>& labels = {}, const CarryCornersOptions& options = {});

}  // namespace counterpart
