// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/partial.hpp>

namespace counterpart::partial_match {

/// The target as it is and, where that scores less than parts of one shape do, as its mirror image: a left
/// bone's half on a right bone. The better reading is taken if it is clear, and named either way; of two
/// parts the mirror image is named only. Takes twice the time then. Directions and pairs that a person gives
/// tell which reading is meant: no other is tried.
PartialResult match_both_readings(MeshView source, MeshView target, const PartialOptions& options);

}  // namespace counterpart::partial_match
