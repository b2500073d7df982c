// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "estimate.hpp"
#include "fill_map.hpp"
#include "judgment.hpp"
#include "match_exact.hpp"
#include "match_methods.hpp"
#include "match_partial.hpp"
#include "match_spectral.hpp"
#include "refine_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/map/left_out.hpp>
#include <counterpart/match/volume.hpp>
#include <counterpart/spectral/functional_map.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct MatchCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path output, inverse, confidence, initial, functional;
    int functional_size = 100;
    FillArguments fill;
    std::string method = "auto";
    std::shared_ptr<ExactArguments> exact;
    std::vector<MethodCommand> methods;
    std::map<const CLI::Option*, std::string> method_of_option;  // of those that belong to one

    const MethodCommand& named(const std::string& name) const {
        return *std::find_if(methods.begin(), methods.end(),
                             [&](const MethodCommand& m) { return m.name == name; });
    }
    const MethodCommand& chosen() const { return named(method); }
    // Whether a method uses an option that another one brought.
    bool shares(const std::string& name, const std::string& option) const {
        const std::vector<std::string>& shared = named(name).shared_options;
        return std::find(shared.begin(), shared.end(), option) != shared.end();
    }
};

// Adds a method and notes which options came with it.
template <class Add>
void add_method(MatchCommand& command, CLI::App& match, const Add& add) {
    const MethodCommand method = add();
    command.methods.push_back(method);
    for (const CLI::Option* option : match.get_options())
        if (!option->get_name().starts_with("--help"))
            command.method_of_option.try_emplace(option, method.name);
}

// Whether auto may come to use an option; what its choice then does not use, the library tells.
bool is_auto_of(const std::string& method) {
    return method == "exact" || method == "spectral" || method == "partial";
}

// Refuses options that the method does not use, before any work.
void refuse_unused_options(const MatchCommand& command) {
    const std::string& method = command.method;
    for (const auto& [option, owner] : command.method_of_option) {
        if (option->count() == 0 || owner == method || owner.empty()) continue;
        const std::string name = option->get_name();
        if (command.shares(method, name) || (method == "auto" && is_auto_of(owner))) continue;
        throw InvalidInput(
            fmt::format("{} is an option of --method {}; --method {} does not use it", name, owner, method));
    }
    if (!command.confidence.empty() && !command.chosen().has_confidence)
        throw InvalidInput(
            fmt::format("--confidence: --method {} has none; exact, frontiers and spectral do", method));
}

void refuse_unused_options_of_refinement(const MatchCommand& command) {
    if (command.method != "spectral" && command.method != "auto")
        throw InvalidInput(
            "--initial is refined by eigenfunctions: it goes with --method spectral or auto only");
    for (const auto& [option, owner] : command.method_of_option)
        if (option->count() > 0 && !owner.empty())
            throw InvalidInput(
                fmt::format("{} is not used where --initial gives the map", option->get_name()));
}

void write_outputs(const MatchCommand& command, const MatchOutcome& outcome) {
    if (!command.confidence.empty() && outcome.confidence.size() == 0)
        throw InvalidInput("--confidence: this method has none");
    write_vertex_map(outcome.target_from_source, command.output);
    if (!command.inverse.empty())
        write_vertex_map(
            outcome.source_from_target ? *outcome.source_from_target : invert(outcome.target_from_source),
            command.inverse);
    if (!command.confidence.empty()) write_npy(outcome.confidence, command.confidence);
}

void write_functional_map(const MatchCommand& command, const MatchOutcome& outcome,
                          const TriangleMesh& source, const TriangleMesh& target) {
    if (command.functional.empty()) return;
    const Progress progress = progress_bar("eigenfunctions", command.common);
    const EigenBasis source_basis = eigen_basis(source, command.functional_size, part_of(progress, 0, 0.5));
    const EigenBasis target_basis = eigen_basis(target, command.functional_size, part_of(progress, 0.5, 1));
    write_npy(Matrix(functional_map(outcome.target_from_source, source_basis, target_basis,
                                    std::min(source_basis.size(), target_basis.size()))),
              command.functional);
}

// Solids know few options: of the methods', only --allow-mirror.
void refuse_options_of_surfaces(const MatchCommand& command) {
    for (const auto& [option, owner] : command.method_of_option) {
        const std::string name = option->get_name();
        const bool is_common =
            owner.empty() && name != "--initial" && name != "--functional-map" && !name.starts_with("--fill");
        if (option->count() > 0 && !is_common && name != "--allow-mirror")
            throw InvalidInput(fmt::format("{} is not used where solids of tetrahedra are matched", name));
    }
}

MatchMethod method_of_solids(const std::string& name) {
    if (name == "auto") return MatchMethod::automatic;
    for (const MatchMethod method : {MatchMethod::exact, MatchMethod::frontiers, MatchMethod::spectral})
        if (to_string(method) == name) return method;
    throw InvalidInput(
        fmt::format("--method {} does not match solids: use exact, frontiers or spectral", name));
}

void run_solids(const MatchCommand& command, const TetrahedralMesh& source, const TetrahedralMesh& target,
                Stopwatch& watch) {
    refuse_options_of_surfaces(command);
    VolumeOptions options{.method = method_of_solids(command.method),
                          .allow_mirror = command.exact->options.allow_mirror,
                          .n_threads = command.common.threads,
                          .progress = progress_bar("matching", command.common)};
    const VolumeResult result = match_volume(source, target, options);
    options.progress = {};  // ends the bar
    watch.lap("match");
    if (result.method == MatchMethod::exact && !result.identical)
        throw InvalidInput("the solids have different connectivity: " + result.difference);
    MatchOutcome outcome;
    outcome.target_from_source = result.target_from_source;
    outcome.confidence = result.confidence;
    const TriangleMesh source_faces = all_faces(source), target_faces = all_faces(target);
    const MeshPair pair{source_faces, target_faces, command.source, command.target};
    const Judgment judgment{result.messages, {}};
    say_verdict(command.common, judgment, pair);
    write_outputs(command, outcome);
    watch.lap("write");
    say_messages(command.common, result.messages, pair);
    const Index matched = count_matched(result.target_from_source);
    say(command.common, fmt::format("matched {} of {} vertices of solids by '{}' in {:.2f} s -> {}", matched,
                                    source.n_vertices(), to_string(result.method), watch.stages()[1].seconds,
                                    utf8_name(command.output)));
    Json report = {
        {"command", "match"}, {"source", utf8_name(command.source)}, {"target", utf8_name(command.target)}};
    report.update(judgment.report());
    report.update({{"method", to_string(result.method)},
                   {"source_vertices", source.n_vertices()},
                   {"target_vertices", target.n_vertices()},
                   {"source_tetrahedra", source.n_tetrahedra()},
                   {"target_tetrahedra", target.n_tetrahedra()},
                   {"matched_vertices", matched},
                   {"messages", to_json(result.messages)},
                   {"seconds", to_json(watch.stages())},
                   {"stage_seconds", to_json(result.stages)}});
    write_report(report, command.common);
}

struct LoadedMesh {
    TriangleMesh mesh;
    CornerAttribute uv{};  // read only where it is matched
};

LoadedMesh load(const MeshInput& file, const MatchCommand& command) {
    if (command.method != "uv") return {load_mesh(file, command.common)};
    AttributedMesh content = load_attributed_mesh(file, command.common);
    if (content.texture_coordinates.empty()) return {std::move(content.mesh)};
    return {std::move(content.mesh), std::move(content.texture_coordinates.front())};
}

void run(const MatchCommand& command) {
    refuse_unused_options(command);
    if (!command.initial.empty()) refuse_unused_options_of_refinement(command);
    Stopwatch watch;
    if (const auto solids = load_solids(command.source, command.target, command.common)) {
        watch.lap("read");
        return run_solids(command, solids->first, solids->second, watch);
    }
    const LoadedMesh source_file = load(command.source, command), target_file = load(command.target, command);
    const TriangleMesh &source = source_file.mesh, &target = target_file.mesh;
    watch.lap("read");
    const MeshPair pair{source, target, command.source, command.target};
    const MatchInput input{source,         target,
                           command.common, progress_bar("matching", command.common),
                           source_file.uv, target_file.uv};
    if (command.initial.empty()) say_expected_cost(input, command.method);
    MatchOutcome outcome = command.initial.empty() ? command.chosen().run(input)
                                                   : refine_map(input, load_map(command.initial, pair));
    watch.lap("match");
    if (outcome.failure.empty())
        outcome.target_from_source = without_left_out(outcome.target_from_source, source, target);
    if (outcome.source_from_target)
        outcome.source_from_target = without_left_out(*outcome.source_from_target, target, source);
    const Judgment judgment{outcome.messages, outcome.causes};  // not of what fills the gaps
    if (outcome.failure.empty()) {
        fill_map(outcome, input, command.fill);
        say_verdict(command.common, judgment, pair);
        write_outputs(command, outcome);
        write_functional_map(command, outcome, source, target);
    }
    watch.lap("write");

    for (const std::string& line : outcome.summary) say(command.common, line);
    say_messages(command.common, outcome.messages, pair);
    const Index matched = count_matched(outcome.target_from_source);
    if (outcome.failure.empty())
        say(command.common,
            fmt::format("matched {} of {} vertices by '{}' in {:.2f} s -> {}", matched, source.n_vertices(),
                        outcome.method.empty() ? command.method : outcome.method, watch.stages()[1].seconds,
                        utf8_name(command.output)));
    Json report = {
        {"command", "match"}, {"source", utf8_name(command.source)}, {"target", utf8_name(command.target)}};
    report.update(judgment.report());
    report.update({{"method", command.method},
                   {"source_vertices", source.n_vertices()},
                   {"target_vertices", target.n_vertices()},
                   {"matched_vertices", matched},
                   {"summary", outcome.summary},
                   {"messages", to_json(outcome.messages)},
                   {"details", outcome.details},
                   {"seconds", to_json(watch.stages())},
                   {"stage_seconds", to_json(outcome.stages)}});
    write_report(report, command.common);
    if (!outcome.failure.empty()) throw InvalidInput(outcome.failure);
}

}  // namespace

void add_match(CLI::App& program) {
    auto command = std::make_shared<MatchCommand>();
    CLI::App* match = program.add_subcommand(
        "match", "Find the vertex of TARGET that corresponds to each vertex of SOURCE");
    add_mesh(*match, command->common.files, "SOURCE", "--source-object", command->source,
             "Mesh file; solids of tetrahedra are matched inside too")
        ->required();
    add_mesh(*match, command->common.files, "TARGET", "--target-object", command->target, "Mesh file")
        ->required();
    add_output(*match, command->common.files, "-o,--output", command->output, Content::map,
               "Map file, text or .npy: line i = target vertex of source vertex i, 0-based")
        ->required();
    add_output(*match, command->common.files, "--inverse", command->inverse, Content::map,
               "Also write the map from TARGET to SOURCE");
    add_output(*match, command->common.files, "--confidence", command->confidence, Content::matrix,
               "Write the confidence of each source vertex, 0 to 1 (.npy)");
    add_input(*match, command->common.files, "--initial", command->initial,
              "Refine this map from SOURCE to TARGET by eigenfunctions, instead of searching for one");
    add_output(*match, command->common.files, "--functional-map", command->functional, Content::matrix,
               "Also write the map as a functional map (.npy): functions on TARGET to functions on SOURCE");
    match
        ->add_option("--functional-size", command->functional_size,
                     "Number of eigenfunctions of --functional-map")
        ->check(whole_number(1, 1000))
        ->capture_default_str();
    CLI::Option* const fill = match->add_flag(
        "--fill", command->fill.all,
        "Give vertices without a partner an image that follows those around them, instead of -1; --inverse "
        "stays as it is");
    match
        ->add_option("--fill-edges", command->fill.max_edges,
                     "The same, but only for vertices at most this many edges from one with a partner")
        ->option_text("N")
        ->check(whole_number(1, 1'000'000))
        ->excludes(fill);
    const auto exact = command->exact = std::make_shared<ExactArguments>();
    const auto spectral = std::make_shared<SpectralArguments>();
    const auto partial = std::make_shared<PartialArguments>();
    for (const CLI::Option* option : match->get_options()) command->method_of_option[option] = "";
    add_method(*command, *match, [&] { return add_auto_method(exact, spectral, partial); });
    add_method(*command, *match, [&] { return add_exact_method(*match, exact); });
    add_method(*command, *match, [&] { return add_frontiers_method(*match); });
    add_method(*command, *match, [&] { return add_spectral_method(*match, spectral); });
    add_method(*command, *match, [&] { return add_partial_method(*match, partial, spectral); });
    add_method(*command, *match, [&] { return add_place_method(*match); });
    add_method(*command, *match, [&] { return add_uv_method(*match); });
    add_method(*command, *match, [&] { return add_nearest_method(*match); });
    add_method(*command, *match, [&] { return add_assignment_method(*match); });
    FileArguments& files = command->common.files;
    for (const FileArgument& file : files_of(spectral->landmarks)) files.push_back(file);
    files.push_back({"--cache", &spectral->cache, nullptr, Content::folder});
    files.push_back({"--alternatives-output", &spectral->alternatives, nullptr, Content::map});
    files.push_back({"--symmetric-alternatives", &exact->alternatives, nullptr, Content::prefix});

    std::vector<std::string> names;
    std::string help = "One of";
    for (const MethodCommand& method : command->methods) {
        names.push_back(method.name);
        help += fmt::format("\n  {}: {}", method.name, method.summary);
    }
    match->add_option("--method", command->method, help)->check(one_of(names))->capture_default_str();
    add_common_options(*match, command->common);
    on_run(*match, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
