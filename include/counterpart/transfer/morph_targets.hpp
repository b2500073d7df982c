// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/transfer/coverage.hpp>

#include <vector>

namespace counterpart {

struct CarriedMorphs {
    std::vector<MorphTarget> morphs;  ///< of the target's vertices, names and order as given
    /// Unmatched vertices move with those around them; guessed ones do not move.
    Coverage coverage;
};

/// Blend shapes for the target: each displacement, interpolated on the source, is turned and stretched as the
/// map turns and stretches the surface there (see local_linear_maps), so that a smile on a wider face is a
/// wider smile. Throws InvalidInput if the map or a morph does not fit the meshes.
CarriedMorphs carry_morphs(const SurfaceMap& source_from_target, const TriangleMesh& source,
                           const TriangleMesh& target, const std::vector<MorphTarget>& morphs);

}  // namespace counterpart
