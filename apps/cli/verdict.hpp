// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "load_map.hpp"
#include "match_methods.hpp"

#include <string>
#include <vector>

namespace counterpart::cli {

/// Whether to rely on a map, in words: "use", "check" or "do not use", and why and where.
struct Verdict {
    std::string word, reason;

    std::string sentence() const { return reason.empty() ? word : word + ": " + reason; }
};

/// From the method's confidence and warnings.
Verdict verdict_on(const MatchOutcome& outcome, const TriangleMesh& source);

/// A verdict and, unless it is "use", what may be the cause, the likeliest first.
struct Judgment {
    Verdict verdict;
    std::vector<std::string> causes;

    /// What every report of a command that matches holds.
    Json report() const;
};
Judgment judge(const MatchOutcome& outcome, const MeshPair& pair);
/// Says the verdict and the causes, unless --quiet.
void say(const CommonOptions& options, const Judgment& judgment);

}  // namespace counterpart::cli
