// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "arrays.hpp"
#include "content.hpp"
#include "guarded.hpp"
#include "match_options.hpp"

#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/match/match.hpp>
#include <counterpart/match/verdict.hpp>

#include <utility>

#include <emscripten/bind.h>
#include <fmt/format.h>

namespace counterpart::javascript {
namespace {

val runner_ups_of(const MatchResult& result) {
    val runner_ups = val::array();
    const auto add = [&](const VertexMap& map, const std::string& description) {
        val runner_up = val::object();
        runner_up.set("targetFromSource", array_of(map));
        runner_up.set("description", description);
        runner_ups.call<void>("push", runner_up);
    };
    if (result.spectral && result.method == MatchMethod::spectral)
        for (const SpectralAlternative& other : result.spectral->alternatives)
            add(other.target_from_source, other.description);
    if (result.partial && result.method == MatchMethod::partial)
        for (const PartialAlternative& other : result.partial->alternatives)
            add(other.target_from_source,
                fmt::format("{:.0f} % of the vertices go elsewhere", 100 * other.moved));
    return runner_ups;
}

val seconds_of(const std::vector<StageTime>& stages) {
    val seconds = val::object();
    for (const StageTime& stage : stages) seconds.set(stage.stage, stage.seconds);
    return seconds;
}

val match_contents(const Content& source, const Content& target, const std::string& json, const val& initial,
                   const val& progress) {
    return guarded([&] {
        MatchOptions options = match_options_of(json);
        if (!initial.isNull())
            options.spectral.initial = {numbers_of<Index>(initial), target.mesh().n_vertices()};
        options.progress = progress_of(progress);
        const MatchResult result = match(source.mesh(), target.mesh(), options);
        const Verdict found = verdict(result);
        val fields = val::object();
        fields.set("targetFromSource", array_of(result.target_from_source));
        fields.set("confidence", array_of(result.confidence));
        fields.set("method", to_string(result.method));
        fields.set("reason", result.reason);
        fields.set("isSameConnectivity", result.exact && result.exact->identical);
        fields.set("nMatched", count_matched(result.target_from_source));
        fields.set("nFilled", result.n_filled);
        fields.set("verdict", to_string(found.advice));
        fields.set("verdictReason", reason(found));
        fields.set("messages", array_of(result.messages));
        fields.set("causes", array_of(result.causes));
        fields.set("runnerUps", runner_ups_of(result));
        fields.set("seconds", seconds_of(result.stages));
        return fields;
    });
}

val evaluate_map(const Content& source, const Content& target, const val& map, const val& truth) {
    return guarded([&] {
        const Index n = target.mesh().n_vertices();
        const EvaluationReport report =
            evaluate(VertexMap(numbers_of<Index>(map), n),
                     truth_from_map(VertexMap(numbers_of<Index>(truth), n)), source.mesh(), target.mesh());
        val fields = val::object();
        fields.set("nPairs", report.n_pairs);
        fields.set("nUnmatched", report.n_unmatched);
        fields.set("nOtherComponent", report.n_other_component);
        fields.set("nExact", report.n_exact);
        fields.set("meanError", report.mean_error);
        fields.set("medianError", report.median_error);
        fields.set("percentile95Error", report.percentile_95_error);
        fields.set("maxError", report.max_error);
        fields.set("error", array_of(report.error));
        return fields;
    });
}

}  // namespace

EMSCRIPTEN_BINDINGS(matching) {
    emscripten::function("match", &match_contents);
    emscripten::function("evaluate", &evaluate_map);
}

}  // namespace counterpart::javascript
