// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

namespace counterpart::cli {

/// `match --fill` and `--fill-edges`.
struct FillArguments {
    bool all = false;
    std::optional<int> max_edges{};  ///< see CompleteOptions
};

/// Unmatched vertices get images that follow those around them; matched ones keep theirs. The inverse stays
/// that of what was matched.
void fill_map(MatchOutcome& outcome, const MatchInput& input, const FillArguments& arguments);

}  // namespace counterpart::cli
