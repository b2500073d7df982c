// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/complete.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>

#include <vector>

namespace counterpart::attributes {

struct TransferCornersOptions {
    int n_threads = 0;  ///< 0 = all; does not change the result
};

struct TransferredCorners {
    CornerAttribute attribute;              ///< of the target's triangles
    std::vector<Index> source_from_target;  ///< for each target triangle the source triangle it maps to
    Coverage coverage;                      ///< of the target's vertices
    Index seam_triangles = 0;               ///< target triangles with an edge on a seam
    Index moved_vertices = 0;     ///< images of target vertices moved onto a seam, for this attribute only
    double largest_move = 0;      ///< farthest move, on the source, in its mesh units
    Index without_triangles = 0;  ///< target triangles without values, as the source has none there
};

/// Texture coordinates or colors for the target's corners, interpolated on the source. There is a seam where
/// they jump between adjacent source triangles (by more than 1e-6 of their range), or where the triangles'
/// `labels` (materials; empty = none) differ.
///
/// No target triangle crosses a seam: along each target edge that would, the end nearer to the seam is moved
/// onto it, so that both sides meet there; each triangle then lies on one side and takes its three values
/// from it. If the map is a vertex permutation between meshes of the same connectivity, values are preserved
/// bit for bit. Unmatched vertices get images by complete_map. Equal values at a vertex share a row. Throws
/// InvalidInput if the map, the attribute or the labels do not fit. O(F log F) for meshes of similar
/// resolution.
TransferredCorners transfer_corners(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                                    const CornerAttribute& attribute, const std::vector<Index>& labels = {},
                                    const TransferCornersOptions& options = {});

/// Normals for the target's corners (n x 3 unit vectors): hard edges are where the source's are, and each
/// normal has the same relation to the target's surface as the source's normal to the source's. It is rotated
/// as the edges around it are, and then by the rotation from the source's geometric normal there to the
/// target's. Geometric normals are area-weighted means over the triangles that share the normal. Edited
/// normals are thus preserved, on a copy up to rounding. Throws as transfer_corners does.
TransferredCorners transfer_normals(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                                    const CornerAttribute& normals,
                                    const TransferCornersOptions& options = {});

/// Whether each corner has the normal of its triangle on a surface that is smooth: of the edges that bend,
/// most do by less than 30 degrees. O(T).
bool is_shaded_flat(MeshView mesh, const CornerAttribute& normals);

struct TransferSkinOptions {
    /// Maximum number of joints per vertex, 1 .. 64; those with the largest weights are kept. 0 = the
    /// source's K (4 or 8 in glTF).
    int max_influences = 0;
};

struct TransferredSkin {
    SkinBinding skin;  ///< of the target's vertices; with the source's joint indices
    Coverage coverage;
    Index limited = 0;  ///< vertices that lost influences to the limit
    Index unbound = 0;  ///< vertices on components of the source without joints; their weights are 0
};

/// Skin weights for the target: interpolated per joint between the source's vertices, limited, summing to 1.
/// An image at a source vertex gets its row bit for bit. Unmatched vertices get the harmonic extension of the
/// weights around them. Throws InvalidInput if map or binding do not fit the meshes, a weight is negative or
/// not finite, or a vertex's weights sum to zero while others in its component do not. O(V K log K).
TransferredSkin transfer_skin(const SurfaceMap& source_from_target, MeshView source, MeshView target,
                              const SkinBinding& skin, const TransferSkinOptions& options = {});

struct TransferredMorphTargets {
    std::vector<MorphTarget> morphs;  ///< of the target's vertices, names and order as given
    /// Unmatched vertices move with their neighbors; guessed ones do not move.
    Coverage coverage;
};

/// Blend shapes for the target: each displacement, interpolated on the source, is rotated and stretched as
/// the map rotates and stretches the surface there, so that a smile on a wider face is a wider smile. Throws
/// InvalidInput if the map or a morph does not fit the meshes.
TransferredMorphTargets transfer_morph_targets(const SurfaceMap& source_from_target, MeshView source,
                                               MeshView target, const std::vector<MorphTarget>& morphs);

}  // namespace counterpart::attributes
