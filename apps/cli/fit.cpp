// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "known_pairs.hpp"
#include "load_map.hpp"

#include <counterpart/align/fit_surface.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/render/color.hpp>

#include <algorithm>
#include <memory>
#include <numeric>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct FitCommand {
    CommonOptions common;
    MeshInput model, scan;
    std::filesystem::path map, output, distance;
    KnownPairsFiles landmarks;
    bool color = false;
    double largest_color = 0;
    FitOptions options;
};

double quantile(Vector values, double share) {
    const auto place = static_cast<Eigen::Index>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return values[place];
}

CornerAttribute colors_of(const Vector& distance, double largest, const Triangles& triangles) {
    CornerAttribute colors{Matrix(distance.size(), 3), triangles};
    for (Eigen::Index v = 0; v < distance.size(); ++v)
        colors.values.row(v) = render::sample(render::Colormap::magma, std::min(1.0, distance[v] / largest));
    return colors;
}

// The share of the scan's surface, in percent, that lies farther from the fit than 2 % of the diagonal: no
// inaccuracy then, but a part that nothing was laid on.
double bare_percent(const FitResult& fit, const Vector& areas) {
    constexpr double far = 0.02;
    const double all = areas.sum();
    const double bare = (fit.scan_distance.array() > far * fit.scan_diagonal).select(areas, 0).sum();
    return all > 0 ? 100 * bare / all : 0;
}

Json report_of(const FitResult& fit, const Vector& areas) {
    return {{"mean_distance", fit.distance.mean()},
            {"mean_distance_percent_of_diagonal", 100 * fit.distance.mean() / fit.scan_diagonal},
            {"p95_distance", quantile(fit.distance, 0.95)},
            {"largest_distance", fit.distance.maxCoeff()},
            {"mean_scan_distance_percent_of_diagonal",
             100 * areas.dot(fit.scan_distance) / std::max(1e-300, areas.sum()) / fit.scan_diagonal},
            {"folded_edges_percent", 100 * fit.folded_edges},
            {"own_folded_edges_percent", 100 * fit.own_folded_edges},
            {"least_area_ratio", fit.least_area_ratio},
            {"free_vertices", fit.n_free}};
}

void run(const FitCommand& command) {
    Stopwatch watch;
    AttributedMesh model = load_attributed_mesh(command.model, command.common);
    const TriangleMesh scan = load_mesh(command.scan, command.common);
    FitOptions options = command.options;
    options.landmarks = command.landmarks.read(model.mesh, scan);
    watch.lap("read");
    const FoundMap<SurfaceMap> found = surface_map_or_match(
        command.map, {model.mesh, scan, command.model, command.scan}, command.common, options.landmarks);
    watch.lap("match");
    options.n_threads = command.common.threads;
    options.progress = progress_bar("fitting", command.common);
    const FitResult fit = fit_surface(model.mesh, scan, found.map, options);
    options.progress = {};
    watch.lap("fit");

    const Vector scan_areas = vertex_areas(scan);
    const double largest =
        command.largest_color > 0 ? command.largest_color : std::max(1e-12, quantile(fit.distance, 0.98));
    model.mesh.vertices = fit.vertices;
    model.normals = {};
    if (command.color) model.colors = {colors_of(fit.distance, largest, model.mesh.triangles)};
    write_attributed_mesh(model, command.output);
    if (!command.distance.empty()) write_npy(fit.distance, command.distance);
    watch.lap("write");

    say(command.common,
        fmt::format("distance to the scan: mean {:.3g} ({:.3f} % of the diagonal), 95 % within {:.3g}, "
                    "largest {:.3g}",
                    fit.distance.mean(), 100 * fit.distance.mean() / fit.scan_diagonal,
                    quantile(fit.distance, 0.95), fit.distance.maxCoeff()));
    say(command.common,
        fmt::format("folded edges: {:.2f} % ({:.2f} % in the template); {} of {} vertices "
                    "follow their neighbors",
                    100 * fit.folded_edges, 100 * fit.own_folded_edges, fit.n_free, model.mesh.n_vertices()));
    const double bare = bare_percent(fit, scan_areas);
    constexpr double worth_a_word = 0.5;
    if (bare >= worth_a_word)
        warn(fmt::format(
            "{:.1f} % of {} lies bare, farther than 2 % of the diagonal from the fit: the template "
            "lacks that part, or the map leaves it out (landmarks there help)",
            bare, utf8_name(command.scan)));
    if (command.color) say(command.common, fmt::format("colors: pale 0 to dark {:.3g} mesh units", largest));
    say(command.common,
        fmt::format("fitted {} vertices in {:.2f} s -> {}{}", model.mesh.n_vertices(),
                    watch.stages()[2].seconds, utf8_name(command.output), caution(found.report)));
    Json report = {{"command", "fit"},
                   {"template", utf8_name(command.model)},
                   {"scan", utf8_name(command.scan)},
                   {"vertices", model.mesh.n_vertices()}};
    report.update(found.report);
    report.update(report_of(fit, scan_areas));
    report["bare_percent"] = bare;
    report["seconds"] = to_json(watch.stages());
    write_report(report, command.common);
}

}  // namespace

void add_fit(CLI::App& program) {
    auto command = std::make_shared<FitCommand>();
    FileArguments& files = command->common.files;
    CLI::App* fit = program.add_subcommand("fit", "Lay TEMPLATE's mesh, smooth, on the surface of SCAN");
    add_mesh(*fit, files, "TEMPLATE", "--source-object", command->model,
             "Mesh file whose triangles and attributes are kept")
        ->required();
    add_mesh(*fit, files, "SCAN", "--target-object", command->scan,
             "Mesh file whose surface is taken; may have holes")
        ->required();
    add_output(*fit, files, "-o,--output", command->output, Content::mesh,
               "Mesh file for the fitted TEMPLATE")
        ->required();
    add_input(*fit, files, "--map", command->map, "Map from TEMPLATE to SCAN. Default: match them first");
    add_known_pairs(*fit, command->landmarks,
                    "Pairs that must meet; without --map they also guide the match");
    for (const FileArgument& file : files_of(command->landmarks)) files.push_back(file);
    fit->add_option("--stiffness", command->options.stiffness,
                    "How large a feature of SCAN must be to be followed, in edges of TEMPLATE")
        ->check(number(0.1, 10))
        ->capture_default_str();
    fit->add_option("--reach", command->options.reach, "How far SCAN draws, as a fraction of its diagonal")
        ->check(positive())
        ->capture_default_str();
    add_output(*fit, files, "--distance", command->distance, Content::matrix,
               "Write the distance of each vertex to SCAN (.npy)");
    fit->add_flag("--color", command->color, "Color the output by its distance to SCAN, pale to dark");
    fit->add_option("--max-distance", command->largest_color,
                    "Distance of the darkest color, in mesh units. Default: that of the worst 2 %")
        ->check(positive());
    add_common_options(*fit, command->common);
    on_run(*fit, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
