// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <counterpart/match/partial.hpp>

namespace counterpart::cli {

struct PartialArguments {
    PartialOptions options;
    bool fill = false;

    /// With the landmarks and what else is shared with --method spectral.
    PartialOptions options_for(const MatchInput& input, const SpectralArguments& shared) const;
};

/// Messages and report of a result; writes the files that were asked for.
MatchOutcome partial_outcome(const MatchInput& input, const PartialArguments& arguments,
                             const SpectralArguments& shared, const PartialResult& result);

/// --fill: every unmatched vertex follows those around it.
void fill(MatchOutcome& outcome, const MatchInput& input);

}  // namespace counterpart::cli
