// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What a person says about a map, and how far a map goes against it.
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <counterpart/match/spectral.hpp>

#include <utility>
#include <vector>

namespace counterpart::spectral_match {

using VertexPairs = std::vector<std::pair<Index, Index>>;  // of A and B

/// A vertex on each shape, with the distances of all others from it.
struct PriorPair {
    Index a = 0, b = 0;
    VectorF from_a, from_b;
};

struct Priors {
    std::vector<PriorPair> landmarks;  // correspond
    std::vector<PriorPair> excluded;   // do not
    /// Directions that mean the same to both shapes, a column each (3 x at most 3), as either one lies in
    /// space.
    Eigen::Matrix3Xd directions_a = Eigen::Matrix3Xd(3, 0), directions_b = directions_a;
    bool pinned = true;  // landmarks hold exactly
    PriorTuning tuning = {};

    bool empty() const { return landmarks.empty() && excluded.empty() && directions_a.cols() == 0; }
    /// Landmarks that hold exactly.
    VertexPairs pins() const;
};

inline const Priors nothing_known;

/// Pairs of vertices that are matched.
Priors make_priors(const PreparedShape& a, const PreparedShape& b, const VertexPairs& landmarks,
                   const VertexPairs& excluded);

/// What the options say, of input vertices.
Priors make_priors(const PreparedShape& a, const PreparedShape& b, const SpectralOptions& options,
                   const PriorTuning& tuning);

/// Directions that are the same in both frames (aligned, up, facing), a unit column each.
Eigen::Matrix3Xd common_directions(const SpectralOptions& options);

/// The same for A and `mirrored` B.
Priors with_mirrored_b(Priors priors);

/// The same with A and B exchanged.
Priors reversed(Priors priors);

/// To be taken off the score of maps between the first samples: distances between landmarks and the images of
/// what surrounds them, excluded pairs that are near each other under the map, coordinates along common
/// directions that are not even roughly in the same order.
double disagreement(const PreparedShape& a, const PreparedShape& b, const Priors& priors,
                    const PairedMaps& maps);

}  // namespace counterpart::spectral_match
