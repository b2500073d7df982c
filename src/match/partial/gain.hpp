// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// What two surfaces gain by lying on each other: the energy by which ways of matching two parts are compared.
#pragma once

#include "match/partial/one_way_fit.hpp"

#include <vector>

namespace counterpart::partial_match {

/// Of two parts, of which one lies bent on the other. A vertex of either fits by
/// q = exp(-gap^2 / 2 sigma^2) max(0, n . n') at the closest vertex of the other. What does not fit lacks 1 -
/// q, unless that closest vertex is on or next to a boundary: there the other surface may have gone on. All
/// sums are by area, over both surfaces.
struct Gain {
    std::vector<float> fit_of_part;  // q of each vertex
    double fits = 0, lacks = 0;      // shares of the area of both
    double total = 0;                // fits - weight * lacks: the larger, the better
};

Gain gain(const Surface& part, const Surface& whole, const BentSource& bent, const GainTuning& tuning);

/// Whether each vertex is on the boundary, or shares a triangle with one that is.
std::vector<char> near_boundary(const Surface& surface);

}  // namespace counterpart::partial_match
