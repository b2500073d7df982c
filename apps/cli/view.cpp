// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "load_map.hpp"
#include "truth_options.hpp"
#include "up_axis.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/mesh/adjacency.hpp>
#include <counterpart/render/camera.hpp>
#include <counterpart/viewer/viewer_page.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ViewCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path output;
    std::vector<std::filesystem::path> maps, values;
    TruthOptions truth;
    std::string up = "auto";
    ViewerOptions options;
};

// The errors of the map's vertices, and in words those of its pairs, as `counterpart evaluate` says them.
void add_errors(ViewerMap& shown, const LoadedMap& map, const GroundTruth& truth, const TriangleMesh& source,
                const TriangleMesh& target, const EvaluationOptions& options) {
    const EvaluationReport report = evaluated(map, truth, source, target, options);
    const Vector errors = mean_vertex_errors(truth, report, PairEnd::source, source.n_vertices());
    shown.error.assign(errors.begin(), errors.end());
    shown.evaluation = fmt::format("mean error {:.3f} % of \u221aarea \u00b7 {:.2f} % exact",
                                   report.mean_error, 100.0 * report.n_exact / report.n_pairs);
}

ViewerValues values_of(const std::filesystem::path& file, Index n_vertices) {
    const Matrix values = read_npy(file);
    if (values.cols() != 1 || values.rows() != n_vertices)
        throw InvalidInput(
            fmt::format("{}: holds {} x {} numbers; --values needs one for each of the {} source "
                        "vertices",
                        utf8_name(file), values.rows(), values.cols(), n_vertices));
    return {utf8_name(file.stem()), {values.data(), values.data() + values.size()}};
}

ViewerAppearance appearance_of(AttributedMesh& content, const std::filesystem::path& file,
                               const CommonOptions& common) {
    ViewerAppearance appearance;
    BaseColors found = read_base_colors(content, file, common.read);
    for (const std::string& notice : found.notices) say(common, utf8_name(file) + ": " + notice);
    if (!found.images.empty())
        appearance = {std::move(content.texture_coordinates[0]), std::move(found.images),
                      std::move(found.image_of_triangle)};
    if (!content.colors.empty()) appearance.colors = std::move(content.colors[0]);
    return appearance;
}

// Source vertices of components that several others equal, numbered by their kind; nothing if there are none
// or the meshes are not connected alike.
std::optional<ViewerValues> alike_parts(const TriangleMesh& source, const TriangleMesh& target,
                                        const CommonOptions& common) {
    const Components components = connected_components(Adjacency(source));
    if (components.count < 2) return std::nullopt;
    const ExactResult exact = match_exact(source, target, {.n_threads = common.threads});
    if (!exact.identical || exact.interchangeable.empty()) return std::nullopt;
    std::vector<double> kind_of(static_cast<std::size_t>(components.count), std::nan(""));
    double kind = 0;
    for (const EqualComponents& equal : exact.interchangeable) {
        ++kind;
        for (const Index v : equal.source)
            kind_of[static_cast<std::size_t>(components.of_vertex[static_cast<std::size_t>(v)])] = kind;
    }
    ViewerValues values{"parts alike (may be exchanged), by kind", {}};
    for (const Index component : components.of_vertex)
        values.values.push_back(kind_of[static_cast<std::size_t>(component)]);
    return values;
}

// What match found, with its verdict, and the runner-ups by what they are.
std::vector<ViewerMap> maps_to_show(const FoundMap<VertexMap>& found) {
    std::vector<ViewerMap> maps = {{"match", found.map}};
    maps[0].verdict = found.report.value("verdict", "");
    maps[0].warnings = found.warnings;
    maps[0].confidence.assign(found.confidence.begin(), found.confidence.end());
    for (const auto& [description, map] : found.runner_ups) maps.push_back({description, map});
    return maps;
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

// As the page calls a mesh.
std::string name_of(const MeshInput& mesh) {
    const std::string file = utf8_name(mesh.file.stem());
    return mesh.object ? fmt::format("{} ({})", file, *mesh.object) : file;
}

// view.html in the current folder, or the first view_2.html, ... that is not there: nothing is replaced.
std::filesystem::path unused_page() {
    std::filesystem::path page = "view.html";
    for (int number = 2; std::filesystem::exists(page); ++number) page = fmt::format("view_{}.html", number);
    return page;
}

void run(ViewCommand& command) {
    if (command.output.empty()) {
        command.output = unused_page();
        check_files(command.common.files);
        say(command.common, fmt::format("no -o is given: the page will be {}", utf8_name(command.output)));
    }
    Stopwatch watch;
    AttributedMesh source_content = load_attributed_mesh(command.source, command.common);
    AttributedMesh target_content = load_attributed_mesh(command.target, command.common);
    const TriangleMesh& source = source_content.mesh;
    const TriangleMesh& target = target_content.mesh;
    const MeshPair pair{source, target, command.source, command.target};
    ViewerOptions options = command.options;
    std::vector<LoadedMap> loaded;
    std::vector<ViewerMap> maps;
    Json match_report = Json::object();
    for (const std::filesystem::path& file : command.maps) {
        loaded.push_back(load_map(file, pair));
        maps.push_back({utf8_name(file.stem()), loaded.back().vertices});
    }
    if (maps.empty()) {
        FoundMap<VertexMap> found = matched(pair, command.common);
        maps = maps_to_show(found);
        for (const ViewerMap& map : maps) loaded.push_back({map.target_from_source, std::nullopt});
        match_report = std::move(found.report);
    }
    if (command.up == "auto") command.up = guessed_up(source, command.common);
    options.up = render::find_camera(source, {.direction = "front", .up = command.up}).row(1).transpose();
    for (const std::filesystem::path& file : command.values)
        options.values.push_back(values_of(file, source.n_vertices()));
    if (std::optional<ViewerValues> alike = alike_parts(source, target, command.common))
        options.values.push_back(std::move(*alike));
    options.source_appearance = appearance_of(source_content, command.source, command.common);
    options.target_appearance = appearance_of(target_content, command.target, command.common);
    options.source_name = name_of(command.source);
    options.target_name = name_of(command.target);
    const std::optional<GroundTruth> truth = read_truth(command.truth);
    watch.lap("read");

    if (truth) {
        const EvaluationOptions evaluation{.n_threads = command.common.threads,
                                           .progress = progress_bar("measuring errors", command.common)};
        for (std::size_t i = 0; i < maps.size(); ++i)
            add_errors(maps[i], loaded[i], *truth, source, target, evaluation);
        options.truth = vertex_truth(*truth, source.n_vertices());
    }
    watch.lap("evaluate");
    const std::string page = viewer_page(source, target, maps, options);
    write_file(page, command.output);
    watch.lap("write");

    say(command.common, fmt::format("{} and {} vertices, {} map{} -> {} ({:.1f} MB)", source.n_vertices(),
                                    target.n_vertices(), maps.size(), maps.size() == 1 ? "" : "s",
                                    utf8_name(command.output), static_cast<double>(page.size()) / 1e6));
    Json report = {{"command", "view"},
                   {"source", utf8_name(command.source)},
                   {"target", utf8_name(command.target)},
                   {"output", utf8_name(command.output)},
                   {"source_vertices", source.n_vertices()},
                   {"target_vertices", target.n_vertices()},
                   {"maps", maps.size()},
                   {"bytes", page.size()}};
    report.update(match_report);
    report["seconds"] = to_json(watch.stages());
    write_report(report, command.common);
}

}  // namespace

void add_view(CLI::App& program) {
    auto command = std::make_shared<ViewCommand>();
    CLI::App* view =
        program.add_subcommand("view", "Write a web page that shows two meshes and the maps between them");
    add_mesh(*view, command->common.files, "SOURCE", "--source-object", command->source, "Mesh file")
        ->required();
    add_mesh(*view, command->common.files, "TARGET", "--target-object", command->target, "Mesh file")
        ->required();
    add_input(*view, command->common.files, "--map", command->maps,
              "Map of either kind. Give several to compare them. Default: match the meshes first");
    add_output(*view, command->common.files, "-o,--output", command->output, Content::page,
               "HTML file; opens in any browser, offline. Default: view.html in the current folder, or "
               "view_2.html, ... if that is there");
    add_input(
        *view, command->common.files, "--values", command->values,
        "Numbers per vertex of SOURCE (.npy), to color by: a confidence, a distance. Several may be given");
    add_truth_options(*view, command->common.files, command->truth);
    view->add_option("--up", command->up,
                     "Up axis of SOURCE: auto (a guess, which is said), x, y, z, -x, -y or -z")
        ->check(one_of({"auto", "x", "y", "z", "-x", "-y", "-z"}))
        ->capture_default_str();
    view->add_option("--base", command->options.base_vertex,
                     "Seed vertex of SOURCE for frontiers; -1 = selected automatically")
        ->check(whole_number(-1, 1 << 30))
        ->capture_default_str();
    add_common_options(*view, command->common);
    on_run(*view, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
