// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/choice/decision.hpp"
#include "match/choice/unused_options.hpp"

#include <counterpart/match/choose_method.hpp>

namespace counterpart {

MethodChoice choose_method(MeshView source, MeshView target, const MatchOptions& options) {
    require_valid(source);
    require_valid(target);
    choice::require_valid(options);
    if (options.method != MatchMethod::automatic)
        return {options.method, "", choice::unused_options(options, options.method)};
    Stopwatch watch;
    choice::Decision decision = choice::decide(source, target, options, options.progress, watch);
    return {decision.method, std::move(decision.reason), choice::unused_options(options, decision.method)};
}

}  // namespace counterpart
