// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace counterpart::surface_match {

/// Confidence that a measure of a whole map earns, by a logistic curve: 1/2 at `half`, toward 1 above.
inline double trust(double measure, double half, double width) {
    return 1 / (1 + std::exp((half - measure) / width));
}

/// Confidence that is left of a vertex by what speaks against it there: 1 for 0, 1 / e at `length`.
inline double trust_at(double doubt, double length) { return std::exp(-doubt * doubt / (length * length)); }

}  // namespace counterpart::surface_match
