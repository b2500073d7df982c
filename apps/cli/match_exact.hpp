// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match_methods.hpp"

#include <counterpart/match/exact.hpp>

#include <memory>
#include <string>

namespace counterpart::cli {

struct ExactArguments {
    ExactOptions options;
    bool allow_differences = false;
    std::string alternatives;  // prefix of the files; empty: none
    Index max_alternatives = 100;

    void prepare() { options.max_alternatives = alternatives.empty() ? 0 : max_alternatives; }
};

/// What to say and write of a result; where the connectivity differs, of the differences, which are looked
/// for.
MatchOutcome exact_outcome(const MatchInput& input, const ExactArguments& arguments, ExactResult result);

}  // namespace counterpart::cli
