// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace counterpart::cli {

struct ExactArguments {
    ExactOptions options;
    bool allow_differences = false;
    std::filesystem::path alternatives;  // prefix of the files; empty: none
    Index max_alternatives = 100;

    /// `match --method exact`.
    MatchOutcome run(const MatchInput& input) const;
};

/// Messages and report of a result; where the connectivity differs, also finds and reports the differences.
MatchOutcome exact_outcome(const MatchInput& input, const ExactArguments& arguments, ExactResult result);

/// The same of a partial match.
MatchOutcome differences_outcome(const MatchInput& input, const MeshDifferences& differences);

}  // namespace counterpart::cli
