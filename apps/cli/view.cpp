// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/stopwatch.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/atomic_file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/view/viewer_page.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ViewCommand {
    CommonOptions common;
    std::filesystem::path source, target, output, truth, source_truth, target_truth;
    std::vector<std::filesystem::path> maps;
    int index_base = 0;
    ViewerOptions options;
};

std::optional<GroundTruth> read_truth(const ViewCommand& command) {
    const auto read = [&](const std::filesystem::path& file) {
        return read_vertex_map(file, static_cast<IndexBase>(command.index_base));
    };
    if (!command.truth.empty()) return truth_from_map(read(command.truth));
    if (!command.source_truth.empty())
        return truth_from_template(read(command.source_truth), read(command.target_truth));
    return std::nullopt;
}

// The mean over the pairs of each source vertex, in units of sqrt(target area) / 100.
std::vector<double> vertex_errors(const VertexMap& map, const GroundTruth& truth, const TriangleMesh& source,
                                  const TriangleMesh& target, const EvaluationOptions& options) {
    const EvaluationReport report = evaluate(map, truth, source, target, options);
    const auto n = static_cast<std::size_t>(source.n_vertices());
    std::vector<double> sum(n, 0.0), count(n, 0.0);
    for (std::size_t i = 0; i < truth.pairs.size(); ++i) {
        const auto v = static_cast<std::size_t>(truth.pairs[i].first);
        sum[v] += report.error[static_cast<Eigen::Index>(i)];
        count[v] += 1;
    }
    const double percent = 100 / std::sqrt(report.target_area);
    for (std::size_t v = 0; v < n; ++v)
        sum[v] = count[v] > 0 ? percent * sum[v] / count[v] : std::numeric_limits<double>::quiet_NaN();
    return sum;
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
        VertexMap map = read_vertex_map(file);
        try {
            require_valid(map, source.n_vertices(), target.n_vertices());
        } catch (const InvalidInput& error) {
            throw InvalidInput(fmt::format("{}: {}", file.string(), error.what()));
        }
        map.target_size = target.n_vertices();
        maps.push_back({file.stem().string(), std::move(map)});
    }
    ViewerOptions options = command.options;
    options.source_name = command.source.stem().string();
    options.target_name = command.target.stem().string();
    const std::optional<GroundTruth> truth = read_truth(command);
    watch.lap("read");

    if (truth) {
        const EvaluationOptions evaluation{.n_threads = command.common.threads,
                                           .progress = progress_bar("measuring errors", command.common)};
        for (ViewerMap& map : maps)
            map.error = vertex_errors(map.target_from_source, *truth, source, target, evaluation);
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
    view->add_option("--map", command->maps,
                     "Map file: line i = target vertex of source vertex i, from 0. Several to compare them")
        ->type_name("FILE")
        ->required();
    view->add_option("-o,--output", command->output, "Page to write (.html); opens in any browser, offline")
        ->required();
    auto* truth = view->add_option("--truth", command->truth, "The true map, in a file like --map's")
                      ->type_name("FILE");
    auto* source_truth = view->add_option("--source-truth", command->source_truth,
                                          "Line k = source vertex of template point k")
                             ->type_name("FILE")
                             ->excludes(truth);
    auto* target_truth = view->add_option("--target-truth", command->target_truth,
                                          "Line k = target vertex of template point k")
                             ->type_name("FILE")
                             ->needs(source_truth);
    source_truth->needs(target_truth);
    view->add_option("--index-base", command->index_base, "What the truth files count from")
        ->check(CLI::IsMember({0, 1}))
        ->capture_default_str();
    view->add_option("--up", command->options.up, "The axis that points up: x, y or z; y by default")
        ->type_name("AXIS")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, UpAxis>{{"x", UpAxis::x}, {"y", UpAxis::y}, {"z", UpAxis::z}},
            CLI::ignore_case));
    view->add_option("--base", command->options.base_vertex,
                     "Source vertex that the frontiers start from; -1 = one at an end of the source")
        ->check(CLI::Range(-1, 1 << 30))
        ->capture_default_str();
    add_common_options(*view, command->common);
    view->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
