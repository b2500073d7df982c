// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "align/elastic_fit.hpp"
#include "match/spectral/extremity_matching.hpp"
#include "match/spectral/map.hpp"

#include <span>

namespace counterpart::spectral_match {

/// What is to correspond while a map is refined: what lies between guides follows them.
struct Guides {
    ExtremityPairs extremities = {};
    std::span<const PriorPair> landmarks = {};
    /// 3 x n: heights along these agree.
    Eigen::Matrix3Xd directions_a = Eigen::Matrix3Xd(3, 0), directions_b = directions_a;
};

/// Refines maps of a level, one at a time; the factorizations that all of them share are kept. Not for
/// several threads at once. The level must outlive it.
class Refiner {
  public:
    explicit Refiner(const Level& level);

    /// Each round bends either surface to where the map takes it (align::ElasticFit), puts islands back, fits
    /// functional maps, and takes as partners the vertices nearest by the spectral coordinates of both, by
    /// features, and by places and normals of the bent surface and of the resting one. Pinned landmarks hold.
    /// The result has a score. O(rounds V) and the factorizations.
    Map operator()(const Map& start, const Schedule& schedule, const Guides& guides = {},
                   const ProgressRange& progress = {});

  private:
    const Level& level_;
    std::vector<Index> pinned_a_, pinned_b_;
    align::ElasticFit fit_a_, fit_b_;
};

}  // namespace counterpart::spectral_match
