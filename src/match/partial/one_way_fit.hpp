// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/surface.hpp"
#include "numerics/oriented_neighbors.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

#include <vector>

namespace counterpart::partial_match {

/// The source bent onto the target, and the target vertex that each source vertex then lies at.
struct BentSource {
    std::vector<Index> image;
    Points positions, normals;
    double strain = 0;  ///< see ElasticFit
};

/// Step 5. Bends the source towards the images `start` (-1 = none), stiff at first, then pliable; after each
/// round the images are the target's points closest in place and normal. Only the source is bent: the target
/// may be larger.
BentSource fit_one_way(const Surface& source, const LaplaceBeltrami& laplacian, const Surface& target,
                       const numerics::OrientedNeighbors& on_target, const std::vector<Index>& start,
                       const FitTuning& tuning, const ProgressRange& progress = {});

}  // namespace counterpart::partial_match
