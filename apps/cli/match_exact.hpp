// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/match.hpp>

#include <filesystem>
#include <memory>
#include <string>

namespace counterpart::cli {

struct ExactArguments {
    ExactOptions options;
    bool allow_differences = false;
    std::filesystem::path alternatives;  // prefix of the files; empty: none
    Index max_alternatives = 100;

    /// As match() takes them.
    ExactOptions options_for_match() const;
    /// `match --method exact`.
    MatchOutcome run(const MatchInput& input) const;
};

/// Summary and report of a result by connectivity; writes the files that were asked for.
MatchOutcome exact_outcome(const MatchInput& input, const ExactArguments& arguments,
                           const MatchResult& result);

/// The same of a partial match.
MatchOutcome differences_outcome(const MatchInput& input, const MeshDifferences& differences);

/// Where the connectivity differs and is the same once vertices at one place are merged: that, and the cure.
std::string welding_advice(const TriangleMesh& source, const TriangleMesh& target,
                           const std::string& source_name, const std::string& target_name);

}  // namespace counterpart::cli
