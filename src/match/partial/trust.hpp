// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/pipeline.hpp"

#include <counterpart/match/partial.hpp>

#include <string>
#include <vector>

namespace counterpart::partial_match {

/// How far a fit as a whole deserves trust, in [0, 1].
double trust(const Fit& fit, double misfit, const TrustTuning& tuning);

/// Share of the part's samples that two fits take to different places.
double share_moved(const BentSource& a, const BentSource& b, const Surface& whole, const TrustTuning& tuning);

/// Of each vertex of the part, of the first fit: its trust as a whole, whether the other fits agree, and how
/// near the vertex came to its image.
Vector confidence(const Surface& part, const Surface& whole, const std::vector<Fit>& found, double misfit,
                  const TrustTuning& tuning);

/// Sentences about what makes the match doubtful.
std::vector<std::string> warnings(const PartialResult& result, const spectral_match::Preprocessed& source,
                                  const spectral_match::Preprocessed& target, double misfit,
                                  const TrustTuning& tuning);

}  // namespace counterpart::partial_match
