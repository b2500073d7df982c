// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/geodesic/farthest_points.hpp>
#include <counterpart/io/npy.hpp>

#include <filesystem>
#include <memory>
#include <numeric>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct DistancesCommand {
    CommonOptions common;
    MeshInput mesh;
    std::filesystem::path output;
    bool plain_edges = false;
    Index n_base_vertices = 0;
    std::vector<Index> sources;
    double memory_limit = 8;
};

void require_memory(const DistancesCommand& command, Index n_vertices) {
    const double n = n_vertices;
    const double rows = command.sources.empty() ? n : static_cast<double>(command.sources.size());
    // The matrix and the bytes of the file are in memory together.
    const double gigabytes = 8e-9 * n * (2 * rows + command.n_base_vertices);
    if (gigabytes > command.memory_limit) {
        throw InvalidInput(
            fmt::format("{:.0f} x {:.0f} distances need {:.1f} GB of memory and {:.1f} GB of disk; the limit "
                        "is {} GB; raise it with --memory-limit, or select rows with --sources",
                        rows, n, gigabytes, 8e-9 * n * rows, command.memory_limit));
    }
}

Matrix compute(const DistancesCommand& command, const TriangleMesh& mesh, Json& json) {
    const DistanceGraph graph(mesh, {.shortcuts = !command.plain_edges});
    const DistanceOptions options{command.common.threads, progress_bar("searching", command.common)};
    if (command.n_base_vertices > 0) {
        const SampledDistances distances(
            graph, farthest_point_samples(mesh, graph, {.count = command.n_base_vertices}), options);
        json["farthest_point_samples"] = distances.bases().vertices;
        json["covering_radius"] = distances.bases().covering_radius;
        return distances.matrix();
    }
    std::vector<Index> sources = command.sources;
    if (sources.empty()) {
        sources.resize(static_cast<std::size_t>(mesh.n_vertices()));
        std::iota(sources.begin(), sources.end(), 0);
    }
    return distance_rows(graph, sources, options);
}

void run(const DistancesCommand& command) {
    Stopwatch watch;
    const TriangleMesh mesh = load_mesh(command.mesh, command.common);
    require_memory(command, mesh.n_vertices());
    watch.lap("read");
    Json json = {
        {"command", "distances"}, {"mesh", utf8_name(command.mesh)}, {"vertices", mesh.n_vertices()}};
    const Matrix distances = compute(command, mesh, json);
    watch.lap("distances");
    write_npy(distances, command.output);
    watch.lap("write");
    say(command.common, fmt::format("{} x {} distances in {:.2f} s -> {}", distances.rows(), distances.cols(),
                                    watch.stages()[1].seconds, utf8_name(command.output)));
    json["rows"] = distances.rows();
    json["columns"] = distances.cols();
    json["seconds"] = to_json(watch.stages());
    write_report(json, command.common);
}

}  // namespace

void add_distances(CLI::App& program) {
    auto command = std::make_shared<DistancesCommand>();
    CLI::App* distances =
        program.add_subcommand("distances", "Write geodesic distances between vertices of MESH");
    add_mesh(*distances, command->common.files, "MESH", "--object", command->mesh, "Mesh file")->required();
    add_output(*distances, command->common.files, "-o,--output", command->output, Content::matrix,
               "NumPy file (.npy): float64, row i = distances from vertex i, inf between components")
        ->required();
    auto* all = distances->add_flag_callback(
        "--all", [] {}, "All pairs, by shortest paths (the default)");
    auto* bases = distances
                      ->add_option("--base-vertices", command->n_base_vertices,
                                   "All pairs, approximated from this many farthest-point samples")
                      ->check(whole_number(1, 1 << 30))
                      ->excludes(all);
    distances->add_option("--sources", command->sources, "Only distances from these vertices, e.g. 0,17,42")
        ->delimiter(',')
        ->excludes(all)
        ->excludes(bases);
    distances->add_flag("--plain-edges", command->plain_edges,
                        "Measure along edges only, without shortcuts across them (about 15 % longer)");
    distances->add_option("--memory-limit", command->memory_limit, "Largest amount of memory to use, in GB")
        ->check(positive())
        ->capture_default_str();
    add_common_options(*distances, command->common);
    on_run(*distances, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
