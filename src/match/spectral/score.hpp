// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Equation 4: how good a map is. The only score that maps of vertices are compared by, in the search, in what
// is reported and in confidence.
#pragma once

#include "match/spectral/level.hpp"

#include <limits>

namespace counterpart::spectral_match {

/// The terms of equation 4, each the mean of both directions, so that exchanging the shapes changes nothing.
struct Score {
    double relief = 0;        ///< correlation of fine relief, in [-1, 1]
    double normals = 0;       ///< mean cosine between normals, turned as the map turns their surroundings
    double damage = 0;        ///< mean distance from where the way there and back ends, and tears
    double disagreement = 0;  ///< with what a person has said
    double total = -std::numeric_limits<double>::infinity();  ///< the larger, the better
};

/// Of maps between all vertices of the level. O(V + samples of all neighborhoods).
Score score(const Level& level, const PairedMaps& on_vertices);

/// Per vertex of `from`: the distance from where the way there and back ends, plus how much longer than
/// doubled its edges get.
Vector round_trips_and_tears(const LevelShape& from, const LevelShape& to, const PairedMaps& maps);

}  // namespace counterpart::spectral_match
