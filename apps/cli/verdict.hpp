// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <string>

namespace counterpart::cli {

/// Whether to rely on a map, in words: "use", "check" or "do not use", and why and where.
struct Verdict {
    std::string word, reason;

    std::string sentence() const { return reason.empty() ? word : word + ": " + reason; }
};

/// From the method's confidence and warnings.
Verdict verdict_on(const MatchOutcome& outcome, const TriangleMesh& source);

}  // namespace counterpart::cli
