// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/assignment.hpp>

#include <memory>

namespace counterpart::cli {

MethodCommand add_assignment_method(CLI::App& match) {
    auto options = std::make_shared<AssignmentOptions>();
    match
        .add_option("--assignment-limit", options->max_vertices,
                    "assignment: largest number of vertices accepted (time grows with its cube)")
        ->check(whole_number(1, 100000))
        ->capture_default_str();
    return {"assignment", "optimal one-to-one assignment after aligning the centroids; slow",
            [options](const MatchInput& input) {
                options->progress = input.progress;
                const AssignmentResult result = match_assignment(input.source, input.target, *options);
                options->progress = {};
                MatchOutcome outcome = plain_outcome(input, result.target_from_source);
                outcome.details = {{"sum_of_squared_distances", result.cost}};
                return outcome;
            },
            false};
}

}  // namespace counterpart::cli
