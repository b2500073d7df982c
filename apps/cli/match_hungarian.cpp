// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/hungarian.hpp>

#include <memory>

namespace counterpart::cli {

MatchMethod add_hungarian_method(CLI::App& match) {
    auto options = std::make_shared<HungarianOptions>();
    match
        .add_option("--hungarian-limit", options->max_vertices,
                    "hungarian: refuse meshes with more vertices (time grows with the cube)")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    return {"hungarian", "centres of mass aligned, then the best one-to-one map of the whole meshes; slow",
            [options](const MatchInput& input) {
                options->progress = input.progress;
                const HungarianResult result = match_hungarian(input.source, input.target, *options);
                options->progress = {};
                MatchOutcome outcome;
                outcome.target_from_source = result.target_from_source;
                outcome.details = {{"sum_of_squared_distances", result.cost}};
                return outcome;
            }};
}

}  // namespace counterpart::cli
