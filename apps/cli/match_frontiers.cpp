// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_methods.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/match/frontiers.hpp>
#include <counterpart/match/verdict.hpp>

#include <map>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

const std::map<std::string, Pairing> pairings = {
    {"closest", Pairing::closest}, {"mutual", Pairing::mutual}, {"optimal", Pairing::optimal}};

struct FrontiersArguments {
    FrontiersOptions options;
    CLI::Option* pairing = nullptr;  // --paper pairs the closest unless this is given
    bool positions_only = false, geodesic = false;
    Index n_bands = 0;
};

Json component_to_json(const ComponentMatch& component) {
    return {{"vertices", component.n_vertices},
            {"frontiers", component.n_frontiers},
            {"source_seed", component.source},
            {"target_seed", component.target},
            {"source_test", to_string(component.test)},
            {"alike_target_vertices", component.n_alike},
            {"interchangeable_components", component.n_interchangeable}};
}

MatchOutcome outcome_of(const MatchInput& input, const FrontiersResult& result) {
    MatchOutcome outcome = plain_outcome(input, result.target_from_source, result.confidence);
    outcome.stages = result.stages;
    const ComponentMatch& largest = result.components.front();
    outcome.summary.push_back(
        fmt::format("seeds: source vertex {} -> target vertex {} ({}); {} frontiers{}", largest.source,
                    largest.target, to_string(largest.test), largest.n_frontiers,
                    result.components.size() > 1
                        ? fmt::format(" in the largest of {} components", result.components.size())
                        : ""));
    Index n_interchangeable = 0;
    for (const ComponentMatch& component : result.components) {
        n_interchangeable += component.n_interchangeable > 1 ? 1 : 0;
        if (component.n_alike > 1)
            outcome.summary.push_back(
                fmt::format("{} target vertices match source seed {} by connectivity; positions decided",
                            component.n_alike, component.source));
    }
    if (n_interchangeable > 0)
        outcome.summary.push_back(
            fmt::format("{} components share their connectivity with others; positions decided which match",
                        n_interchangeable));
    const double confidence = result.confidence.mean();
    outcome.summary.push_back(fmt::format("preserved edges: {:.2f} %", 100 * confidence));
    outcome.details["mean_confidence"] = confidence;
    outcome.details["decided_by_position"] = result.n_decided_by_position;
    outcome.details["components"] = Json::array();
    for (const ComponentMatch& component : result.components)
        outcome.details["components"].push_back(component_to_json(component));
    return outcome;
}

MatchOutcome run_geodesic(const FrontiersArguments& arguments, const MatchInput& input) {
    if (arguments.positions_only || arguments.options.edge_splits || arguments.options.paper)
        throw InvalidInput("--paper, --positions-only and --edge-splits need --distance hops");
    GeodesicFrontiersOptions options;
    options.source_seed = arguments.options.source_seed;
    options.target_seed = arguments.options.target_seed;
    options.n_bands = arguments.n_bands;
    if (arguments.pairing->count() > 0) options.pairing = arguments.options.pairing;
    options.n_threads = input.common.threads;
    options.progress = input.progress;
    const GeodesicFrontiersResult result = match_geodesic_frontiers(input.source, input.target, options);
    MatchOutcome outcome;
    outcome.target_from_source = result.target_from_source;
    outcome.messages = result.messages;
    for (Message& doubt : doubts(outcome.target_from_source, {}, input.source))
        outcome.messages.push_back(std::move(doubt));
    outcome.causes = probable_causes(input.source, input.target, outcome.messages);
    outcome.stages = result.stages;
    outcome.summary.push_back(fmt::format(
        "seeds: source vertex {} -> target vertex {}; their area profiles differ by up to {:.1f} %; "
        "{} geodesic bands",
        result.source_seed, result.target_seed, 100 * result.profile_difference, result.n_bands));
    outcome.details = {{"source_seed", result.source_seed},
                       {"target_seed", result.target_seed},
                       {"bands", result.n_bands},
                       {"profile_difference", result.profile_difference}};
    return outcome;
}

}  // namespace

MethodCommand add_frontiers_method(CLI::App& match) {
    auto arguments = std::make_shared<FrontiersArguments>();
    FrontiersOptions& options = arguments->options;
    const std::string group = "Options of --method frontiers";
    match
        .add_option("--source-seed", options.source_seed,
                    "Seed vertex of SOURCE, 0-based; needs --target-seed. Default: selected automatically")
        ->check(whole_number(0, 1 << 30))
        ->group(group);
    match
        .add_option("--target-seed", options.target_seed,
                    "Corresponding seed vertex of TARGET; needs --source-seed")
        ->check(whole_number(0, 1 << 30))
        ->group(group);
    match
        .add_flag("--paper", options.paper,
                  "As published: each whole frontier matched independently, by closest pairs")
        ->group(group);
    match
        .add_flag("--positions-only", arguments->positions_only,
                  "Pair vertices by position and edges only, without subtree hashes")
        ->group(group);
    match.add_flag("--edge-splits", options.edge_splits, "Split edges until there are sqrt(V) frontiers")
        ->group(group);
    arguments->pairing =
        match
            .add_option_function<std::string>(
                "--pairing", [&options](const std::string& name) { options.pairing = pairings.at(name); },
                "closest, mutual or optimal. Default: optimal; closest with --paper")
            ->check(one_of({"closest", "mutual", "optimal"}))
            ->group(group);
    CLI::Option* distance =
        match
            .add_option_function<std::string>(
                "--distance",
                [arguments](const std::string& kind) { arguments->geodesic = kind == "geodesic"; },
                "hops, or geodesic: bands of geodesic distance, matched as published, for any two meshes")
            ->check(one_of({"hops", "geodesic"}))
            ->default_str("hops")
            ->group(group);
    match.add_option("--bands", arguments->n_bands, "Number of bands with --distance geodesic; 0 = sqrt(V)")
        ->check(whole_number(0, 1'000'000))
        ->capture_default_str()
        ->needs(distance)
        ->group(group);
    return {"frontiers", "same connectivity: breadth-first frontiers, level by level",
            [arguments](const MatchInput& input) {
                if (arguments->geodesic) return run_geodesic(*arguments, input);
                FrontiersOptions run_options = arguments->options;
                run_options.vertex_hashes = !arguments->positions_only;
                if (run_options.paper && arguments->pairing->count() == 0)
                    run_options.pairing = Pairing::closest;
                run_options.n_threads = input.common.threads;
                run_options.progress = input.progress;
                try {
                    return outcome_of(input, match_frontiers(input.source, input.target, run_options));
                } catch (const UnsuitableMesh& error) {
                    throw InvalidInput(std::string(error.what()) +
                                       "; --distance geodesic matches meshes of different connectivity");
                }
            }};
}

}  // namespace counterpart::cli
