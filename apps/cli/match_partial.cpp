// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_partial.hpp"

#include "match_spectral.hpp"

#include <counterpart/io/map_file.hpp>

#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

Json partial_report(const PartialResult& result) {
    Json alternatives = Json::array();
    for (const PartialAlternative& other : result.alternatives)
        alternatives.push_back({{"score", other.score}, {"moved_share", other.moved}});
    Json report = {{"part", to_string(result.part)},
                   {"scale", result.scale},
                   {"source_share", result.source_share},
                   {"target_share", result.target_share},
                   {"score", result.score},
                   {"mean_confidence", result.confidence.mean()},
                   {"alternatives", alternatives},
                   {"source_touching", result.source_touching},
                   {"target_touching", result.target_touching}};
    if (result.part != Part::neither) report["agreement"] = result.agreement;
    if (!result.alternatives.empty()) report["margin"] = result.margin;
    if (result.part == Part::both) report["gain_in_mirror"] = result.gain_in_mirror;
    return report;
}

// What was taken for a part of what.
std::string role(Part part) {
    switch (part) {
        case Part::source:
            return "the source is taken for a part of the target";
        case Part::target:
            return "the target is taken for a part of the source";
        case Part::both:
            return "both meshes are taken for parts that overlap";
        default:
            return "both meshes are taken for whole";
    }
}

std::string part_summary(const PartialResult& result) {
    std::string text =
        fmt::format("{}; {:.0f} % of the source's area and {:.0f} % of the target's have a partner",
                    role(result.part), 100 * result.source_share, 100 * result.target_share);
    if (std::abs(result.scale - 1) > 0.005)
        text += fmt::format("; the source is taken {} times as large", readable(result.scale));
    return text;
}

}  // namespace

PartialOptions PartialArguments::options_for(const MatchInput& input, const SpectralArguments& shared) const {
    const SpectralOptions known = shared.options_for(input);
    PartialOptions result = options;
    result.n_alternatives = known.n_alternatives;
    result.seed = shared.shape.seed;
    result.landmarks = known.landmarks;
    result.soft_landmarks = known.soft_landmarks;
    result.excluded = known.excluded;
    result.aligned = known.aligned;
    result.up = known.up;
    result.facing = known.facing;
    result.mirrored = is_mirror_asked(known);
    result.n_threads = input.common.threads;
    result.progress = input.progress;
    return result;
}

MatchOutcome partial_outcome(const SpectralArguments& shared, const PartialResult& result) {
    if (!shared.alternatives.empty())
        for (std::size_t i = 0; i < result.alternatives.size(); ++i)
            write_vertex_map(result.alternatives[i].target_from_source, shared.alternative(i + 1));
    MatchOutcome outcome;
    outcome.summary.push_back(part_summary(result));
    outcome.summary.push_back(
        fmt::format("score {:.3f}, mean confidence {:.2f}", result.score, result.confidence.mean()));
    for (const PartialAlternative& other : result.alternatives)
        outcome.summary.push_back(fmt::format("  runner-up {:.3f}: {} of the part goes elsewhere",
                                              other.score, rounded_percent(other.moved)));
    outcome.details = partial_report(result);
    outcome.stages = result.stages;
    outcome.source_from_target = result.source_from_target;
    return outcome;
}

MethodCommand add_partial_method(CLI::App& match, const std::shared_ptr<PartialArguments>& arguments,
                                 const std::shared_ptr<SpectralArguments>& shared) {
    const std::string group =
        "Options of --method partial (which also uses --landmarks, --soft-landmarks, --not, --aligned, --up, "
        "--facing, --seed, --alternatives)";
    const std::map<std::string, Part> parts{{"unknown", Part::unknown},
                                            {"source", Part::source},
                                            {"target", Part::target},
                                            {"both", Part::both},
                                            {"neither", Part::neither}};
    match
        .add_option("--part", arguments->options.part,
                    "Which mesh shows only a part: source, target, both (parts that overlap), neither "
                    "(whole, perhaps "
                    "fused with itself), unknown (seen from their boundaries)")
        ->transform(CLI::CheckedTransformer(parts, CLI::ignore_case))
        ->option_text("PART [unknown]")
        ->group(group);
    match
        .add_flag("--same-scale", arguments->options.same_scale,
                  "The files share their unit of length: surer and faster than searching the scale")
        ->group(group);
    return {"partial",
            "local shape and distances: parts, meshes with holes, surfaces fused with themselves",
            [arguments, shared](const MatchInput& input) {
                MatchOptions options{.method = MatchMethod::partial,
                                     .partial = arguments->options_for(input, *shared)};
                options.spectral.mirror = shared->options_for(input).mirror;
                options.n_threads = input.common.threads;
                options.progress = input.progress;
                const MatchResult result = counterpart::match(input.source, input.target, options);
                return with_result(partial_outcome(*shared, *result.partial), result);
            },
            true,
            {"--landmarks", "--target-landmarks", "--soft-landmarks", "--not", "--aligned", "--up",
             "--facing", "--mirror", "--symmetric", "--seed", "--alternatives", "--alternatives-output"}};
}

}  // namespace counterpart::cli
