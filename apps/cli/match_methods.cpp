// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/match/verdict.hpp>

#include <utility>

namespace counterpart::cli {

MatchOutcome with_result(MatchOutcome outcome, const MatchResult& result) {
    outcome.target_from_source = result.target_from_source;
    outcome.confidence = result.confidence;
    outcome.messages = result.messages;
    outcome.causes = result.causes;
    if (outcome.stages.empty()) outcome.stages = result.stages;
    return outcome;
}

MatchOutcome plain_outcome(const MatchInput& input, VertexMap target_from_source, Vector confidence) {
    MatchOutcome outcome;
    outcome.target_from_source = std::move(target_from_source);
    outcome.confidence = std::move(confidence);
    outcome.messages = doubts(outcome.target_from_source, outcome.confidence, input.source);
    outcome.causes = probable_causes(input.source, input.target, outcome.messages);
    return outcome;
}

}  // namespace counterpart::cli
