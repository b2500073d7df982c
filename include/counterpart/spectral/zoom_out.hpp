// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/functional_map.hpp>

namespace counterpart {

struct ZoomOutOptions {
    int first = 20;  ///< eigenfunctions of the first step, at least 2
    int last = 150;  ///< of the last one; cut to what the bases have
    int step = 10;   ///< how many more in each step, at least 1
    /// Both directions at once (Ren et al. 2018): the functional maps of p and q are fitted together and
    /// neighbours are sought under both, which keeps the map from collapsing. Else plain ZoomOut.
    bool bijective = true;
    /// Damp what pairs far frequencies (Hu et al. 2021); only with `bijective`.
    bool masked = true;
    int n_threads = 0;  ///< 0 = all; the result does not depend on it
};

struct ZoomOutResult {
    VertexMap target_from_source, source_from_target;
    FunctionalMap source_functions_from_target;  ///< of the last step
};

/// Refines a rough vertex map by going from few to many eigenfunctions: vertex map -> functional map ->
/// vertex map, a few more functions each time. Melzi et al., "ZoomOut", 2019. `source_from_target`: the way
/// back if it is known; without it the nearest neighbours of the first functional map. All vertices of both
/// maps must be matched. Throws InvalidInput for maps between other meshes and options out of range.
/// O(V_source V_target last) a step: for above 20 000 vertices use match_spectral.
ZoomOutResult zoom_out(const VertexMap& target_from_source, const EigenBasis& source,
                       const EigenBasis& target, const ZoomOutOptions& options = {},
                       const VertexMap& source_from_target = {});

}  // namespace counterpart
