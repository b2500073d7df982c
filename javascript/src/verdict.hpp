// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/match.hpp>

#include <string>

namespace counterpart::javascript {

/// Whether to rely on a map: "use", "check" or "do not use", and why.
struct Verdict {
    std::string word, reason;
};
Verdict verdict_on(const MatchResult& result, MeshView source);

}  // namespace counterpart::javascript
