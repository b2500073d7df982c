// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <utility>

namespace counterpart::cli {

MethodCommand add_place_method(CLI::App& /*match*/) {
    return {"place", "what lies in the same place, part by part, as the meshes are",
            [](const MatchInput& input) {
                const MatchResult result = match(input.source, input.target,
                                                 {.method = MatchMethod::place,
                                                  .n_threads = input.common.threads,
                                                  .progress = input.progress});
                return with_result({}, result);
            }};
}

}  // namespace counterpart::cli
