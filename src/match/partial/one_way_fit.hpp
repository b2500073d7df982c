// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/surface.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

#include <utility>
#include <vector>

namespace counterpart::partial_match {

/// The source bent onto the target, and the target vertex that each source vertex then lies at.
struct BentSource {
    std::vector<Index> image;
    Points positions, normals;
    double strain = 0;  ///< see ElasticFit
    std::vector<std::pair<Index, Index>> pins;
};

/// Step 5. Bends the source towards the images `start` (-1 = none), stiff at first, then pliable; after each
/// round the images are the target's points closest in place and normal. Only the source is bent: the target
/// may be larger. Pairs that are known, `pins`, pull with all their trust, and are images of each other in
/// the end.
BentSource fit_one_way(const Surface& source, const LaplaceBeltrami& laplacian, const Surface& target,
                       const numerics::OrientedNeighbors& on_target, const std::vector<Index>& start,
                       std::vector<std::pair<Index, Index>> pins, const FitTuning& tuning,
                       const ProgressRange& progress = {});

}  // namespace counterpart::partial_match
