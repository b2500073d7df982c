// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <counterpart/match/partial.hpp>

namespace counterpart::cli {

struct PartialArguments {
    PartialOptions options;

    /// With the landmarks and what else is shared with --method spectral.
    PartialOptions options_for(const MatchInput& input, const SpectralArguments& shared) const;
};

/// Messages and report of a result; writes the files that were asked for.
MatchOutcome partial_outcome(const SpectralArguments& shared, const PartialResult& result);

}  // namespace counterpart::cli
