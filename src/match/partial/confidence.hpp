// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/pipeline.hpp"

#include <counterpart/match/partial.hpp>

#include <optional>
#include <vector>

namespace counterpart::partial_match {

/// What a finished fit looks like.
struct Finish {
    double misfit = 0;  ///< see PartnerMaps
    double share = 1;   ///< of the area that has partners: the larger of both meshes'
};

/// Of a fit as a whole, in [0, 1].
double whole_confidence(const Fit& fit, const Finish& finish, const ConfidenceTuning& tuning);

/// Share of the part's samples that two fits take to different places.
double share_moved(const BentSource& a, const BentSource& b, const Surface& whole,
                   const ConfidenceTuning& tuning);

/// Of each vertex of the part, of the first fit before it is finished: the confidence of the whole, whether
/// the other fits agree, and how near the vertex came to its image.
Vector confidence(const Surface& part, const Surface& whole, const std::vector<Fit>& found,
                  const Finish& finish, const ConfidenceTuning& tuning);

/// The best other way in which the part fits that takes a noticeable share of it elsewhere.
struct Elsewhere {
    double score = 0;   ///< of that fit
    double behind = 0;  ///< the first one, in totals
    double moved = 0;   ///< share of the part's vertices
};
std::optional<Elsewhere> best_elsewhere(const std::vector<Fit>& found, const Surface& whole,
                                        const ConfidenceTuning& tuning);

/// What was noticed in the meshes, and what makes the match doubtful.
std::vector<Message> messages_on(const PartialResult& result, const surface_match::Preprocessed& source,
                                 const surface_match::Preprocessed& target, double misfit,
                                 const std::optional<Elsewhere>& elsewhere, const ConfidenceTuning& tuning);

}  // namespace counterpart::partial_match
