// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/spectral/functional_map.hpp>

namespace counterpart {

struct ZoomOutOptions {
    int first = 20;  ///< eigenfunctions in the first step, at least 2
    int last = 150;  ///< in the last step; limited by the bases
    int step = 10;   ///< added in each step, at least 1
    /// Refine both directions at once (Ren et al. 2018): their functional maps are fitted together and
    /// nearest neighbors are found under both, which keeps the map from collapsing. Else plain ZoomOut.
    bool bijective = true;
    /// Damp entries that pair distant frequencies (Hu et al. 2021); only with `bijective`.
    bool masked = true;
    int n_threads = 0;    ///< 0 = all; does not change the result
    Progress progress{};  ///< see base/progress.hpp
};

struct ZoomOutResult {
    VertexMap target_from_source, source_from_target;
    FunctionalMap source_functions_from_target;  ///< of the last step
};

/// Refines a rough vertex map by going from few to many eigenfunctions: vertex map -> functional map ->
/// vertex map, with more functions each time. Melzi et al., "ZoomOut", 2019. `source_from_target`: the
/// inverse map if known; without it, the nearest neighbors under the first functional map. All vertices of
/// both maps must be matched. Throws InvalidInput for maps between other meshes and options out of range.
/// O(V_source V_target last) a step: for above 20 000 vertices use match_spectral.
ZoomOutResult zoom_out(const VertexMap& target_from_source, const EigenBasis& source,
                       const EigenBasis& target, const ZoomOutOptions& options = {},
                       const VertexMap& source_from_target = {});

}  // namespace counterpart
