// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "refine_map.hpp"

#include <counterpart/match/refine.hpp>

#include <fmt/format.h>

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
    outcome.messages.push_back(fmt::format("refined the given map: {} of {} images stayed", refined.n_kept,
                                           input.source.n_vertices()));
    outcome.details = {{"kept_images", refined.n_kept}};
    outcome.stages = std::move(refined.stages);
    return outcome;
}

}  // namespace counterpart::cli
