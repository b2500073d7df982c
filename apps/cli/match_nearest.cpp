// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/nearest.hpp>

namespace counterpart::cli {

MethodCommand add_nearest_method(CLI::App& /*match*/) {
    return {"nearest", "closest vertex after aligning the centroids (the paper's naive baseline)",
            [](const MatchInput& input) {
                MatchOutcome outcome;
                outcome.target_from_source =
                    match_nearest(input.source, input.target, {.n_threads = input.common.threads})
                        .target_from_source;
                return outcome;
            },
            false};
}

}  // namespace counterpart::cli
