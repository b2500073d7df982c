// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "refine_map.hpp"

#include <counterpart/match/refine.hpp>
#include <counterpart/match/verdict.hpp>

namespace counterpart::cli {

MatchOutcome refine_map(const MatchInput& input, const LoadedMap& initial) {
    const RefineOptions options{.n_threads = input.common.threads, .progress = input.progress};
    RefineResult refined =
        initial.points ? counterpart::refine_map(*initial.points, input.source, input.target, options)
                       : counterpart::refine_map(initial.vertices, input.source, input.target, options);
    MatchOutcome outcome;
    outcome.method = "spectral";
    outcome.target_from_source = std::move(refined.target_from_source);
    outcome.source_from_target = std::move(refined.source_from_target);
    outcome.confidence = std::move(refined.confidence);
    outcome.messages = std::move(refined.messages);
    outcome.causes = probable_causes(input.source, input.target, outcome.messages);
    outcome.details = {{"kept_images", refined.n_kept}};
    outcome.stages = std::move(refined.stages);
    return outcome;
}

}  // namespace counterpart::cli
