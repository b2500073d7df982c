// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "estimate.hpp"
#include "match_exact.hpp"
#include "match_methods.hpp"
#include "match_partial.hpp"
#include "match_spectral.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/match.hpp>

#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

MatchOptions options_of(const MatchInput& input, const ExactArguments& exact,
                        const SpectralArguments& spectral, const PartialArguments& partial) {
    MatchOptions options = spectral.match_options_for(input);
    options.exact = exact.options_for_match();
    options.partial = partial.options_for(input, spectral);
    return options;
}

// Summary and report of the method that answered; writes the files it was asked for.
MatchOutcome outcome_of(const MatchInput& input, const ExactArguments& exact,
                        const SpectralArguments& spectral, const MatchResult& result) {
    if (result.method == MatchMethod::partial) return partial_outcome(spectral, *result.partial);
    if (result.method == MatchMethod::spectral) return spectral_outcome(spectral, *result.spectral);
    if (result.method != MatchMethod::exact) return {};
    if (result.exact && result.exact->identical) return exact_outcome(input, exact, result);
    MatchOutcome outcome = differences_outcome(input, *result.differences);
    outcome.details["filled_vertices"] = result.n_filled;
    return outcome;
}

// Symmetric alternatives are only those of an exact match: what comes instead takes longer than asking first.
void require_same_connectivity(const MatchInput& input, const ExactArguments& exact) {
    if (exact.alternatives.empty()) return;
    const ExactResult result = match_exact(input.source, input.target, exact.options);
    if (!result.identical)
        throw InvalidInput("--symmetric-alternatives is an option of --method exact, which cannot match: " +
                           result.difference);
}

// The other methods merge what coincides, and nothing else.
void require_useful_welding(const MatchInput& input, const ExactArguments& exact) {
    if (exact.options.weld_distance <= 0) return;
    const ExactResult result = match_exact(input.source, input.target, exact.options);
    if (!result.identical)
        throw InvalidInput(fmt::format(
            "--weld {}: the connectivity differs also after that ({}), and the methods for different "
            "connectivity merge only vertices that coincide: weld the files first with 'convert --weld {}', "
            "or "
            "leave --weld out",
            exact.options.weld_distance, result.difference, exact.options.weld_distance));
}

}  // namespace

MethodCommand add_auto_method(const std::shared_ptr<ExactArguments>& exact,
                              const std::shared_ptr<SpectralArguments>& spectral,
                              const std::shared_ptr<PartialArguments>& partial) {
    return {"auto",
            "exact if the connectivity is the same or nearly so, place if the surfaces coincide, partial if "
            "a mesh is open, "
            "else spectral; "
            "reports the choice and the reason",
            [exact, spectral, partial](const MatchInput& input) {
                if (exact->allow_differences) {
                    MatchOutcome outcome = exact->run(input);
                    outcome.method = "exact";
                    return outcome;
                }
                require_same_connectivity(input, *exact);
                require_useful_welding(input, *exact);
                const MatchOptions options = options_of(input, *exact, *spectral, *partial);
                if (input.source.n_triangles() != input.target.n_triangles())
                    say_expected_cost(input, "spectral",
                                      "unless a part is matched or the connectivity is alike, ");
                const MatchResult result = match(input.source, input.target, options);
                MatchOutcome outcome = with_result(outcome_of(input, *exact, *spectral, result), result);
                outcome.method = to_string(result.method);
                outcome.summary.insert(
                    outcome.summary.begin(),
                    fmt::format("auto: {}, because {}", to_string(result.method), result.reason));
                if (!spectral->alternatives.empty() && !result.spectral && !result.partial)
                    outcome.summary.push_back(fmt::format(
                        "--alternatives-output: '{}' has no runner-ups to write", to_string(result.method)));
                outcome.details["chosen_method"] = to_string(result.method);
                outcome.details["reason"] = result.reason;
                return outcome;
            }};
}

}  // namespace counterpart::cli
