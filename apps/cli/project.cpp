// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/io/map_file.hpp>
#include <counterpart/map/invert.hpp>

#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ProjectCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path map, output, inverse;
    int extend = 0;
};

void run(const ProjectCommand& command) {
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    SurfaceMap target_from_source = load_surface_map(
        command.map, {source, target, command.source, command.target}, command.common, command.extend);
    Json report = {{"command", "project"},
                   {"source_vertices", source.n_vertices()},
                   {"matched_vertices", count_matched(target_from_source)}};
    if (!command.inverse.empty()) {
        const MapPair pair = with_inverse(
            target_from_source, source, target,
            {.n_threads = command.common.threads, .progress = progress_bar("inverting", command.common)});
        target_from_source = pair.target_from_source;
        write_surface_map(pair.source_from_target, command.inverse);
        report["inverse_matched_vertices"] = count_matched(pair.source_from_target);
    }
    write_surface_map(target_from_source, command.output);
    say(command.common,
        fmt::format("{} of {} source vertices are mapped to a point on the target -> {}",
                    count_matched(target_from_source), source.n_vertices(), utf8_name(command.output)));
    write_report(report, command.common);
}

}  // namespace

void add_project(CLI::App& program) {
    auto command = std::make_shared<ProjectCommand>();
    CLI::App* project = program.add_subcommand(
        "project", "Convert a vertex map to a sub-vertex map (triangle and barycentric weights)");
    add_mesh(*project, command->common.files, "SOURCE", "--source-object", command->source, "Mesh file")
        ->required();
    add_mesh(*project, command->common.files, "TARGET", "--target-object", command->target, "Mesh file")
        ->required();
    add_input(*project, command->common.files, "--map", command->map, "Map from SOURCE to TARGET")
        ->required()
        ->type_name("FILE");
    add_output(*project, command->common.files, "-o,--output", command->output, Content::map,
               "Map file, text or .npy: line i = target triangle and three weights of source vertex i")
        ->required();
    add_output(*project, command->common.files, "--inverse", command->inverse, Content::map,
               "Also write the sub-vertex map from TARGET to SOURCE, made consistent with the other")
        ->type_name("FILE");
    project
        ->add_option("--extend", command->extend,
                     "Rounds of extending the map to unmatched neighbors of matched vertices; 0 to 1000")
        ->check(whole_number(0, 1000))
        ->capture_default_str();
    add_common_options(*project, command->common);
    on_run(*project, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
