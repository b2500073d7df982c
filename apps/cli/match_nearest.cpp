// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/nearest.hpp>

namespace counterpart::cli {

MethodCommand add_nearest_method(CLI::App& /*match*/) {
    return {"nearest", "closest vertex after aligning the centroids (the paper's naive baseline)",
            [](const MatchInput& input) {
                return plain_outcome(
                    input, match_nearest(input.source, input.target, {.n_threads = input.common.threads})
                               .target_from_source);
            },
            false};
}

}  // namespace counterpart::cli
