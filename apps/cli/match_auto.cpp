// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_exact.hpp"
#include "match_methods.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {

// Exact if it applies, because its answer is a fact; else the best method for meshes that are connected
// differently: the first of this list that is there.
MatchMethod add_auto_method(const std::vector<MatchMethod>& methods,
                            const std::shared_ptr<ExactArguments>& exact) {
    return {"auto", "exact if the connectivity is the same, else spectral; says which and why",
            [methods, exact](const MatchInput& input) {
                exact->prepare();
                ExactResult result = match_exact(input.source, input.target, exact->options);
                if (result.identical || exact->allow_differences) {
                    const char* const reason = result.identical
                                                   ? "auto: exact, because the two meshes are connected alike"
                                                   : "auto: exact, because of --allow-differences";
                    MatchOutcome outcome = exact_outcome(input, *exact, std::move(result));
                    outcome.messages.insert(outcome.messages.begin(), reason);
                    outcome.details["chosen_method"] = "exact";
                    return outcome;
                }
                for (const char* name : {"spectral", "nearest"}) {
                    const auto method = std::find_if(methods.begin(), methods.end(),
                                                     [&](const MatchMethod& m) { return m.name == name; });
                    if (method == methods.end()) continue;
                    const std::string reason = fmt::format("auto: {}, because the connectivity differs: {}",
                                                           name, result.difference);
                    say(input.common, reason);
                    MatchOutcome outcome = method->run(input);
                    outcome.details["chosen_method"] = name;
                    outcome.details["reason"] = reason;
                    return outcome;
                }
                return exact_outcome(input, *exact, std::move(result));
            }};
}

}  // namespace counterpart::cli
