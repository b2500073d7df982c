// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/uv.hpp>

#include <utility>

namespace counterpart::cli {

MethodCommand add_uv_method(CLI::App& /*match*/) {
    return {"uv", "what has the same texture coordinates, in any poses", [](const MatchInput& input) {
                MatchOptions options{
                    .method = MatchMethod::uv, .n_threads = input.common.threads, .progress = input.progress};
                options.uv.source = input.source_uv;
                options.uv.target = input.target_uv;
                const MatchResult result = match(input.source, input.target, options);
                MatchOutcome outcome = with_result({}, result);
                outcome.details = {{"source_share", result.uv->source_share},
                                   {"target_share", result.uv->target_share},
                                   {"seam_agreement", result.uv->seam_agreement},
                                   {"by_place", result.uv->n_by_place},
                                   {"undecided", result.uv->n_undecided}};
                return outcome;
            }};
}

}  // namespace counterpart::cli
