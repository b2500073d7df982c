// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/sampled_pair.hpp"

namespace counterpart::spectral_match {

/// Stage 2b. Maps of samples for shapes in similar poses, which intrinsic distances cannot find if the
/// proportions differ: nearest samples after the principal axes are aligned in each of the 24 ways that
/// preserve orientation, followed by ICP.
std::vector<PairedMaps> extrinsic_candidates(const SampledPair& pair, int n_iterations);

}  // namespace counterpart::spectral_match
