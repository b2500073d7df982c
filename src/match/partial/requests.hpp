// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/pipeline.hpp"

#include <counterpart/match/partial.hpp>
#include <counterpart/match/spectral.hpp>

#include <utility>
#include <vector>

namespace counterpart::partial_match {

/// What is known of the map besides landmarks.
struct Requests {
    std::vector<std::pair<Index, Index>> excluded;  ///< vertices of the part and of the whole
    Eigen::Matrix3Xd directions;                    ///< that mean the same to both, a column each
};

/// The options as those of the spectral method that say the same.
SpectralOptions as_of_spectral(const PartialOptions& options);

/// Takes from the totals of the fits what goes against the requests, and puts the best one first.
void rank(std::vector<Fit>& found, const Surface& part, const Surface& whole, const Requests& requests,
          const spectral_match::PriorTuning& tuning);

}  // namespace counterpart::partial_match
