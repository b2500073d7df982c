// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "load_map.hpp"
#include "truth_options.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ViewCommand {
    CommonOptions common;
    std::filesystem::path source, target, output;
    std::vector<std::filesystem::path> maps;
    TruthOptions truth;
    ViewerOptions options;
};

std::vector<double> source_errors(const VertexMap& map, const GroundTruth& truth, const TriangleMesh& source,
                                  const TriangleMesh& target, const EvaluationOptions& options) {
    const EvaluationReport report = evaluate(map, truth, source, target, options);
    const Vector errors = mean_vertex_errors(truth, report, PairEnd::source, source.n_vertices());
    return {errors.begin(), errors.end()};
}

// The first true target vertex of each source vertex.
std::vector<Index> vertex_truth(const GroundTruth& truth, Index n_source) {
    std::vector<Index> image(static_cast<std::size_t>(n_source), VertexMap::unmatched);
    for (const auto& [from, to] : truth.pairs) {
        Index& entry = image[static_cast<std::size_t>(from)];
        if (entry == VertexMap::unmatched) entry = to;
    }
    return image;
}

void run(const ViewCommand& command) {
    Stopwatch watch;
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    std::vector<ViewerMap> maps;
    for (const std::filesystem::path& file : command.maps) {
        maps.push_back({file.stem().string(), load_vertex_map(file, source, target)});
    }
    ViewerOptions options = command.options;
    options.source_name = command.source.stem().string();
    options.target_name = command.target.stem().string();
    const std::optional<GroundTruth> truth = read_truth(command.truth);
    watch.lap("read");

    if (truth) {
        const EvaluationOptions evaluation{.n_threads = command.common.threads,
                                           .progress = progress_bar("measuring errors", command.common)};
        for (ViewerMap& map : maps)
            map.error = source_errors(map.target_from_source, *truth, source, target, evaluation);
        options.truth = vertex_truth(*truth, source.n_vertices());
    }
    watch.lap("evaluate");
    const std::string page = viewer_page(source, target, maps, options);
    write_file(page, command.output);
    watch.lap("write");

    say(command.common, fmt::format("{} and {} vertices, {} map{} -> {} ({:.1f} MB)", source.n_vertices(),
                                    target.n_vertices(), maps.size(), maps.size() == 1 ? "" : "s",
                                    command.output.string(), static_cast<double>(page.size()) / 1e6));
    write_report({{"command", "view"},
                  {"source", command.source.string()},
                  {"target", command.target.string()},
                  {"output", command.output.string()},
                  {"source_vertices", source.n_vertices()},
                  {"target_vertices", target.n_vertices()},
                  {"maps", maps.size()},
                  {"bytes", page.size()},
                  {"seconds", to_json(watch.stages())}},
                 command.common);
}

}  // namespace

void add_view(CLI::App& program) {
    auto command = std::make_shared<ViewCommand>();
    CLI::App* view =
        program.add_subcommand("view", "Write a web page that shows two meshes and the maps between them");
    view->add_option("SOURCE", command->source, "Mesh file (.off, .obj, .ply, .stl, .glb, .gltf)")
        ->required();
    view->add_option("TARGET", command->target, "Mesh file")->required();
    view->add_option(
            "--map", command->maps,
            "Map file: line i = target vertex of source vertex i, 0-based. Give several to compare them")
        ->type_name("FILE")
        ->required();
    view->add_option("-o,--output", command->output, "HTML file; opens in any browser, offline")->required();
    add_truth_options(*view, command->truth);
    view->add_option("--up", command->options.up, "Up axis: x, y or z. Default: y")
        ->type_name("AXIS")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, UpAxis>{{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}},
            CLI::ignore_case));
    view->add_option("--base", command->options.base_vertex,
                     "Seed vertex of SOURCE for frontiers; -1 = selected automatically")
        ->check(CLI::Range(-1, 1 << 30))
        ->capture_default_str();
    add_common_options(*view, command->common);
    view->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
