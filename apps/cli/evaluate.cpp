// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "load_map.hpp"
#include "truth_options.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/evaluation/evaluate.hpp>
#include <counterpart/evaluation/map_quality.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/mesh/measure.hpp>

#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>
#include <utility>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct EvaluateCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path map, curve;
    TruthOptions truth;
    Index samples = 0;
    bool plain_edges = false, overlap = false;
    EvaluationOptions options;
};

double percent(Index part, Index whole) { return whole > 0 ? 100.0 * part / whole : 0; }

// Percentage of the matched pairs with an error up to the threshold.
double within(const EvaluationReport& report, double threshold) {
    double share = 0;
    for (std::size_t i = 0; i < report.thresholds.size() && report.thresholds[i] <= threshold; ++i)
        share = report.fraction_within[i];
    return 100 * share;
}

std::string describe(const MapQuality& quality, const TriangleMesh& source, const TriangleMesh& target) {
    return fmt::format(
        "map         {} of {} source vertices matched, to {} of {} target vertices ({:.1f} %)\n"
        "edges       {:.2f} % of the source edges map to target edges, {:.2f} % collapse to a point\n",
        quality.n_matched, source.n_vertices(), quality.n_distinct, target.n_vertices(),
        100 * quality.coverage, 100 * quality.preserved_edges, 100 * quality.collapsed_edges);
}

std::string describe(const EvaluationReport& report) {
    std::string text =
        fmt::format("truth       {} pairs: {} ({:.2f} %) exactly right, {} unmatched", report.n_pairs,
                    report.n_exact, percent(report.n_exact, report.n_pairs), report.n_unmatched);
    if (report.n_other_component > 0)
        text += fmt::format(", {} in another component", report.n_other_component);
    if (report.n_unmatched + report.n_other_component == report.n_pairs)
        return text + "\nerror       nothing to measure: no vertex is matched within its true component\n";
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "\nerror       mean {:.3f}, median {:.3f}, 95th percentile {:.3f}, largest {:.3f}\n",
                   report.mean_error, report.median_error, report.percentile_95_error, report.max_error);
    fmt::format_to(out,
                   "            (geodesic distance to the true vertex x 100 / sqrt of the target's area)\n");
    fmt::format_to(out, "within      1: {:.2f} %   5: {:.2f} %   10: {:.2f} %   25: {:.2f} %\n",
                   within(report, 1), within(report, 5), within(report, 10), within(report, 25));
    fmt::format_to(out, "C           {:.4g} (sum of squared distances), {:.4g} (their mean / area)\n",
                   report.cost.raw, report.cost.normalized);
    if (report.base_vertex_cost)
        fmt::format_to(out, "C sampled   {:.4g}, {:.4g} (approximated from farthest-point samples)\n",
                       report.base_vertex_cost->raw, report.base_vertex_cost->normalized);
    return text;
}

std::string describe(const OverlapReport& report) {
    return fmt::format(
        "overlap     {:.2f} % of {} vertices with a partner missed, {:.2f} % of {} without one matched; "
        "IoU {:.3f}\n",
        100 * report.missed, report.n_paired, 100 * report.invented, report.n_unpaired, report.iou);
}

Json json_of(const OverlapReport& report) {
    return {{"missed", report.missed}, {"invented", report.invented}, {"iou", report.iou}};
}

Json json_of(const CorrespondenceCost& cost) { return {{"raw", cost.raw}, {"normalized", cost.normalized}}; }

Json json_of(const MapQuality& quality) {
    return {{"matched", quality.n_matched},
            {"distinct_images", quality.n_distinct},
            {"coverage", quality.coverage},
            {"preserved_edges", quality.preserved_edges},
            {"collapsed_edges", quality.collapsed_edges}};
}

Json json_of(const EvaluationReport& report) {
    Json json = {{"pairs", report.n_pairs},
                 {"unmatched", report.n_unmatched},
                 {"other_component", report.n_other_component},
                 {"exact", report.n_exact},
                 {"exact_share", static_cast<double>(report.n_exact) / report.n_pairs},
                 {"mean_error", report.mean_error},
                 {"median_error", report.median_error},
                 {"p95_error", report.percentile_95_error},
                 {"max_error", report.max_error},
                 {"target_area", report.target_area},
                 {"cost", json_of(report.cost)}};
    if (report.base_vertex_cost) json["base_vertex_cost"] = json_of(*report.base_vertex_cost);
    json["curve"] = {{"error", report.thresholds}, {"fraction_within", report.fraction_within}};
    return json;
}

void write_curve(const EvaluationReport& report, const std::filesystem::path& file) {
    std::string csv = "error,fraction_within\n";
    for (std::size_t i = 0; i < report.thresholds.size(); ++i)
        fmt::format_to(std::back_inserter(csv), "{},{}\n", report.thresholds[i], report.fraction_within[i]);
    write_file(csv, file);
}

// Solids are measured along the edges inside too, relative to the area of the target's surface.
std::pair<TriangleMesh, TriangleMesh> load_meshes(EvaluateCommand& command) {
    if (const auto solids = load_solids(command.source, command.target, command.common)) {
        command.options.target_area = surface_area(boundary(solids->second).mesh);
        return {all_faces(solids->first), all_faces(solids->second)};
    }
    return {load_mesh(command.source, command.common), load_mesh(command.target, command.common)};
}

void run(EvaluateCommand& command) {
    Stopwatch watch;
    const auto [source, target] = load_meshes(command);
    const LoadedMap map = load_map(command.map, {source, target, command.source, command.target});
    std::optional<GroundTruth> truth = read_truth(command.truth);
    const std::optional<OverlapReport> overlap =
        truth && command.overlap ? std::optional(evaluate_overlap(map.vertices, *truth)) : std::nullopt;
    if (truth && command.samples > 0) truth = sampled(*truth, command.samples);
    watch.lap("read");

    const MapQuality quality = map_quality(map.vertices, source, target);
    std::string text = describe(quality, source, target);
    Json json = {{"command", "evaluate"},
                 {"source", utf8_name(command.source)},
                 {"target", utf8_name(command.target)},
                 {"map", utf8_name(command.map)},
                 {"source_vertices", source.n_vertices()},
                 {"target_vertices", target.n_vertices()},
                 {"quality", json_of(quality)}};
    if (truth) {
        command.options.shortcuts = !command.plain_edges;
        command.options.n_threads = command.common.threads;
        command.options.progress = progress_bar("measuring", command.common);
        const EvaluationReport report = evaluated(map, *truth, source, target, command.options);
        command.options.progress = {};  // ends the bar
        text += describe(report);
        json["distances"] = command.plain_edges ? "plain edges" : "edges and shortcuts";
        json["errors"] = json_of(report);
        if (overlap) {
            text += describe(*overlap);
            json["overlap"] = json_of(*overlap);
        }
        if (!command.curve.empty()) write_curve(report, command.curve);
    } else {
        text += "truth       not given; see --truth\n";
    }
    watch.lap("evaluate");
    json["seconds"] = to_json(watch.stages());
    print(command.common, text);
    write_report(json, command.common);
}

}  // namespace

void add_evaluate(CLI::App& program) {
    auto command = std::make_shared<EvaluateCommand>();
    CLI::App* evaluate = program.add_subcommand(
        "evaluate",
        "Measure the quality of a map from SOURCE to TARGET, and its errors if the truth is given");
    add_mesh(*evaluate, command->common.files, "SOURCE", "--source-object", command->source, "Mesh file")
        ->required();
    add_mesh(*evaluate, command->common.files, "TARGET", "--target-object", command->target, "Mesh file")
        ->required();
    add_input(*evaluate, command->common.files, "MAP", command->map,
              "Map file: line i = target vertex of source vertex i, 0-based; or a surface map")
        ->required();
    add_truth_options(*evaluate, command->common.files, command->truth);
    evaluate
        ->add_option("--samples", command->samples,
                     "Measure at most this many true pairs, evenly spaced; 0 = all")
        ->check(whole_number(0, 1 << 30))
        ->capture_default_str();
    evaluate
        ->add_option("--base-vertices", command->options.n_base_vertices,
                     "Also approximate C from this many farthest-point samples; 0 = do not")
        ->check(whole_number(0, 100000))
        ->capture_default_str();
    evaluate->add_flag("--overlap", command->overlap,
                       "Vertices in no true pair have no partner: count those that are missed and invented");
    evaluate->add_flag("--plain-edges", command->plain_edges,
                       "Measure along edges only, without shortcuts across them (about 15 % longer)");
    add_output(*evaluate, command->common.files, "--curve", command->curve, Content::table,
               "Write the fraction of pairs within each error to this CSV file")
        ->type_name("FILE");
    add_common_options(*evaluate, command->common);
    on_run(*evaluate, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
