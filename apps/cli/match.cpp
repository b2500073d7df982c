// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "match_exact.hpp"
#include "match_methods.hpp"
#include "match_spectral.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/map_file.hpp>

#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct MatchCommand {
    CommonOptions common;
    std::filesystem::path source, target, output;
    std::string method = "auto";
    std::vector<MethodCommand> methods;
};

void run(const MatchCommand& command) {
    Stopwatch watch;
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    watch.lap("read");
    const auto method = std::find_if(command.methods.begin(), command.methods.end(),
                                     [&](const MethodCommand& m) { return m.name == command.method; });
    const MatchOutcome outcome =
        method->run({source, target, command.common, progress_bar("matching", command.common)});
    watch.lap("match");
    if (outcome.failure.empty()) write_vertex_map(outcome.target_from_source, command.output);
    watch.lap("write");

    for (const std::string& message : outcome.messages) say(command.common, message);
    const Index matched = count_matched(outcome.target_from_source);
    if (outcome.failure.empty())
        say(command.common,
            fmt::format("matched {} of {} vertices by '{}' in {:.2f} s -> {}", matched, source.n_vertices(),
                        method->name, watch.stages()[1].seconds, command.output.string()));
    write_report({{"command", "match"},
                  {"source", command.source.string()},
                  {"target", command.target.string()},
                  {"method", method->name},
                  {"source_vertices", source.n_vertices()},
                  {"target_vertices", target.n_vertices()},
                  {"matched_vertices", matched},
                  {"messages", outcome.messages},
                  {"details", outcome.details},
                  {"seconds", to_json(watch.stages())},
                  {"stage_seconds", to_json(outcome.stages)}},
                 command.common);
    if (!outcome.failure.empty()) throw InvalidInput(outcome.failure);
}

}  // namespace

void add_match(CLI::App& program) {
    auto command = std::make_shared<MatchCommand>();
    CLI::App* match = program.add_subcommand(
        "match", "Find the vertex of TARGET that corresponds to each vertex of SOURCE");
    match->add_option("SOURCE", command->source, "Mesh file (.off, .obj, .ply, .stl, .glb, .gltf)")
        ->required();
    match->add_option("TARGET", command->target, "Mesh file")->required();
    match
        ->add_option("-o,--output", command->output,
                     "Map file, text or .npy: line i = target vertex of source vertex i, 0-based")
        ->required();
    const auto exact = std::make_shared<ExactArguments>();
    const auto spectral = std::make_shared<SpectralArguments>();
    command->methods = {add_auto_method(exact, spectral), add_exact_method(*match, exact),
                        add_frontiers_method(*match),     add_spectral_method(*match, spectral),
                        add_nearest_method(*match),       add_assignment_method(*match)};

    std::vector<std::string> names;
    std::string help = "One of";
    for (const MethodCommand& method : command->methods) {
        names.push_back(method.name);
        help += fmt::format("\n  {}: {}", method.name, method.summary);
    }
    match->add_option("--method", command->method, help)->check(CLI::IsMember(names))->capture_default_str();
    add_common_options(*match, command->common);
    match->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
