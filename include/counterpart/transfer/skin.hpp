// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/attributed_mesh.hpp>
#include <counterpart/transfer/coverage.hpp>

namespace counterpart {

struct CarrySkinOptions {
    /// Joints per vertex at most, 1 .. 64; the heaviest are kept. 0 = as many as the source's binding has
    /// room for (its K, for glTF 4 or 8).
    int max_influences = 0;
};

struct CarriedSkin {
    SkinBinding skin;  ///< of the target's vertices; joints are numbered as in the source
    Coverage coverage;
    Index limited = 0;  ///< vertices that lost influences to the limit
    Index unbound = 0;  ///< vertices on parts of the source that have no joints at all; their weights are 0
};

/// Skin weights for the target: between the source's vertices interpolated joint by joint, limited, summing
/// to 1. At a source vertex its row comes back bit by bit. Unmatched vertices take the smoothest continuation
/// of the weights around them. Throws InvalidInput if map or binding do not fit the meshes, a weight is
/// negative or not finite, or a vertex' weights sum to zero while others of its component have some.
/// O(V K log K).
CarriedSkin carry_skin(const SurfaceMap& source_from_target, const TriangleMesh& source,
                       const TriangleMesh& target, const SkinBinding& skin,
                       const CarrySkinOptions& options = {});

}  // namespace counterpart
