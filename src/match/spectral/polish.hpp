// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/contenders.hpp"

namespace counterpart::spectral_match {

/// A map that was not taken.
struct RunnerUp {
    Map map;        // refined a little
    double behind;  // the best, by equation 4, when both were last compared
};

/// Between all vertices of the whole shapes.
struct Polished {
    Map best;
    std::vector<RunnerUp> runners_up;
};

/// A map of samples over all vertices, not refined.
Map spread_over(const Level& whole, const Map& map);

/// A map grown by ZoomOut on all samples, and whether the shapes are nearly isometric by it.
struct NearIsometry {
    Map grown;
    bool is_one;
};
NearIsometry grown_near_isometry(const Level& whole, const Map& map);

/// Grown further, and refined on all vertices with relief as a feature.
Map refined_near_isometry(const Level& whole, const NearIsometry& near, const ProgressRange& progress);

/// Stage 5. The leader of the race on all vertices. Where it is nearly an isometry it is grown by ZoomOut and
/// refined there; otherwise all maps in the race are refined on copies of more vertices, the best once more
/// with both maps pulling, and then there. Of the maps that were not taken up to `n_runners_up` that are
/// distinct.
Polished polish(Contenders contenders, const Level& whole, std::size_t n_runners_up,
                const ProgressRange& progress);

}  // namespace counterpart::spectral_match
