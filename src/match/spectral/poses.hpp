// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/scores.hpp"

namespace counterpart::spectral_match {

/// Maps of samples for shapes in alike poses, which intrinsic distances cannot find if the proportions
/// differ: nearest samples after the principal axes are laid onto each other in each of the 24 ways that keep
/// left and right apart, and moved by a few iterations of ICP.
std::vector<PairedMaps> maps_between_poses(const SampledPair& pair);

}  // namespace counterpart::spectral_match
