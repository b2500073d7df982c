// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/transfer/coverage.hpp>

#include <string>
#include <vector>

namespace counterpart {

/// What to carry; what the source has not is not carried, and what the target has already stays.
struct TransferOptions {
    bool colors = true;
    bool texture_coordinates = true;
    bool normals = true;
    bool skin = true;
    bool morphs = true;
    bool material = true;    ///< what each triangle is made of: see TransferResult::source_parts
    int max_influences = 0;  ///< joints per vertex at most; 0 = as the source, see CarrySkinOptions
    int n_threads = 0;       ///< 0 = all; the result does not depend on it
};

/// How one attribute arrived; counts that do not concern it are 0. See carry_corners and carry_skin.
struct TransferredAttribute {
    std::string name;
    Coverage coverage;
    Index seam_triangles = 0, moved_vertices = 0, without_triangles = 0;
    Index limited_vertices = 0, unbound_vertices = 0;
};

struct TransferResult {
    AttributedMesh content;  ///< the target's mesh with the source's attributes instead of its own
    std::vector<TransferredAttribute> attributes;
    /// With skin or material: for each target triangle the part of the source that it lies on.
    std::vector<Index> source_parts;
};

/// Carries the source's attributes to the target: see carry_corners, carry_normals, carry_skin and
/// carry_morphs. A skeleton lives in the file that the source is from: with the skin the target takes over
/// the source's `document`, unchanged, and its `parts`; the skeleton is right where the target has the
/// source's bind pose and place. Otherwise the target keeps its own, and io's with_materials brings the
/// materials into it. Without any documents the source's parts, being labels, become the target's. Throws
/// InvalidInput if map or attributes do not fit the meshes.
TransferResult transfer_attributes(const SurfaceMap& source_from_target, const AttributedMesh& source,
                                   const AttributedMesh& target, const TransferOptions& options = {});

}  // namespace counterpart
