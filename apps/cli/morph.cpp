// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/gltf.hpp>
#include <counterpart/io/mesh_file.hpp>
#include <counterpart/transfer/morph.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct MorphCommand {
    CommonOptions common;
    MeshInput first, last;
    std::filesystem::path map, output;
    std::string format = ".obj";
    int count = 24;
    double frames_per_second = 24;
    CLI::Option* format_option = nullptr;
    CLI::Option* speed_option = nullptr;
    MorphOptions options;
};

Json measured(const TriangleMesh& first, const Points& last, const std::vector<Points>& frames) {
    Json rows = Json::array();
    const std::size_t steps = frames.size() + 1;
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const double time = static_cast<double>(k + 1) / static_cast<double>(steps);
        const double before_time = static_cast<double>(k) / static_cast<double>(steps);
        const MorphQuality quality =
            measure_morph(first, last, time, frames[k], k == 0 ? first.vertices : frames[k - 1]);
        const MorphQuality linear =
            measure_morph(first, last, time, Points((1 - time) * first.vertices + time * last),
                          Points((1 - before_time) * first.vertices + before_time * last));
        rows.push_back({{"time", time},
                        {"mean_edge_error", quality.mean_edge_error},
                        {"volume_ratio", quality.volume_ratio},
                        {"inverted_triangles", quality.inverted_triangles},
                        {"linear_mean_edge_error", linear.mean_edge_error},
                        {"linear_volume_ratio", linear.volume_ratio},
                        {"linear_inverted_triangles", linear.inverted_triangles}});
    }
    return rows;
}

std::string worst_of(const Json& rows, const std::string& prefix) {
    double error = 0, volume = rows.empty() ? 1 : 1e300;
    Index inverted = 0;
    for (const Json& row : rows) {
        error = std::max(error, row[prefix + "mean_edge_error"].get<double>());
        volume = std::min(volume, row[prefix + "volume_ratio"].get<double>());
        inverted += row[prefix + "inverted_triangles"].get<Index>();
    }
    return fmt::format("largest mean edge error {:.2f} %, least volume {:.1f} %, {} inverted triangles",
                       100 * error, 100 * volume, inverted);
}

void require_used(const MorphCommand& command) {
    if (is_gltf(command.output) && command.format_option->count() > 0)
        throw InvalidInput("--format is of frames in a folder; --output names one file");
    if (!is_gltf(command.output) && command.speed_option->count() > 0)
        throw InvalidInput("--fps is of an animation: --output must then be a .glb or .gltf file");
}

// The first key frame with its attributes; each further frame is a morph target, and an animation plays them.
void write_morph_targets(AttributedMesh content, const std::vector<Points>& frames, const Points& last,
                         const MorphCommand& command) {
    content.morphs.clear();
    const Points& first = content.mesh.vertices;
    for (const Points& frame : frames)
        content.morphs.push_back({fmt::format("frame_{:04}", content.morphs.size() + 1), frame - first});
    content.morphs.push_back({fmt::format("frame_{:04}", content.morphs.size() + 1), last - first});
    write_gltf(content, command.output, command.frames_per_second);
}

// An earlier run may have left more frames, or some of another format, that a player would show too.
void warn_of_other_frames(const MorphCommand& command, std::size_t n_written) {
    std::vector<std::string> others;
    for (const auto& entry : std::filesystem::directory_iterator(command.output)) {
        const std::string name = utf8_name(entry.path().filename());
        unsigned number = 0;
        if (std::sscanf(name.c_str(), "frame_%u", &number) != 1) continue;
        if (number >= n_written || entry.path().extension() != command.format) others.push_back(name);
    }
    if (others.empty()) return;
    std::sort(others.begin(), others.end());
    warn(fmt::format(
        "{} also holds {} that this run did not write, from {} to {}: delete what you do not want",
        utf8_name(command.output), counted(static_cast<Index>(others.size()), "frame"), others.front(),
        others.back()));
}

// With what the first key frame has that no pose changes: no normals, no skeleton.
void write_frames(AttributedMesh content, const std::vector<Points>& frames, const Points& last,
                  const MorphCommand& command) {
    std::error_code failure;
    std::filesystem::create_directories(command.output, failure);
    if (failure)
        throw IoError(
            fmt::format("{}: cannot create folder ({})", utf8_name(command.output), failure.message()));
    const auto write = [&](const Points& vertices, std::size_t number) {
        content.mesh.vertices = vertices;
        write_attributed_mesh(content, command.output / fmt::format("frame_{:04}{}", number, command.format));
    };
    content.normals = {};
    content.skin = {};
    content.morphs.clear();
    if (content.document) content.document = content.document->without_skeleton();
    write(Points(content.mesh.vertices), 0);
    for (std::size_t k = 0; k < frames.size(); ++k) write(frames[k], k + 1);
    write(last, frames.size() + 1);
    warn_of_other_frames(command, frames.size() + 2);
}

void run(const MorphCommand& command) {
    require_used(command);
    Stopwatch watch;
    const AttributedMesh first_content = load_attributed_mesh(command.first, command.common);
    const TriangleMesh& first = first_content.mesh;
    const TriangleMesh last = load_mesh(command.last, command.common);
    MorphOptions options = command.options;
    options.n_threads = command.common.threads;
    const FoundMap<SurfaceMap> found =
        surface_map_or_match(command.map, {first, last, command.first, command.last}, command.common);
    const LastPose placed = last_pose(first, last, found.map);
    const Points& pose = placed.vertices;
    if (placed.n_followers > 0)
        say(command.common, fmt::format("{} unmatched vertices follow their neighbors", placed.n_followers));
    watch.lap("read");
    const std::vector<Points> frames =
        morph_frames(first, pose, command.count, options, progress_bar("morphing", command.common));
    watch.lap("morph");

    if (is_gltf(command.output))
        write_morph_targets(first_content, frames, pose, command);
    else
        write_frames(first_content, frames, pose, command);
    watch.lap("write");

    const Json rows = measured(first, pose, frames);
    say(command.common, "as rigid as possible: " + worst_of(rows, ""));
    say(command.common, "linear blending:      " + worst_of(rows, "linear_"));
    say(command.common,
        fmt::format("{} and the two key frames in {:.2f} s -> {}{}",
                    counted(static_cast<Index>(frames.size()), "in-between"), watch.stages()[1].seconds,
                    utf8_name(command.output), caution(found.report)));
    Json report = {{"command", "morph"},
                   {"first", utf8_name(command.first)},
                   {"last", utf8_name(command.last)},
                   {"vertices", first.n_vertices()}};
    report.update(found.report);
    report["frames"] = rows;
    report["seconds"] = to_json(watch.stages());
    write_report(report, command.common);
}

}  // namespace

void add_morph(CLI::App& program) {
    auto command = std::make_shared<MorphCommand>();
    CLI::App* morph = program.add_subcommand("morph", "Interpolate between two poses A and B");
    add_mesh(*morph, command->common.files, "A", "--source-object", command->first,
             "Mesh file: the first key frame, whose connectivity is kept")
        ->required();
    add_mesh(*morph, command->common.files, "B", "--target-object", command->last,
             "Mesh file: the last key frame")
        ->required();
    add_input(*morph, command->common.files, "--map", command->map,
              "Map from A to B. Default: match them first, unless they have the same triangles")
        ->type_name("FILE");
    morph->add_option("-n,--frames", command->count, "Number of in-between frames; 0 to 10000")
        ->check(whole_number(0, 10000))
        ->capture_default_str();
    add_output(
        *morph, command->common.files, "-o,--output", command->output, Content::frames,
        "Folder for frame_0000 (A) to frame_<n+1> (B); or a .glb or .gltf file: A with all attributes "
        "except morph targets, and frame_0001 to frame_<n+1> as its morph targets, played by an animation")
        ->required();
    command->format_option =
        morph->add_option("--format", command->format, "File format of frames in a folder, by its extension")
            ->check(one_of(mesh_extensions().written))
            ->capture_default_str();
    command->speed_option = morph
                                ->add_option("--fps", command->frames_per_second,
                                             "Frames per second of the animation in a .glb or .gltf file")
                                ->check(number(0.01, 1000))
                                ->capture_default_str();
    morph
        ->add_option("--iterations", command->options.iterations,
                     "Iterations per frame, 0 to 100; more preserve edge lengths better")
        ->check(whole_number(0, 100))
        ->capture_default_str();
    add_common_options(*morph, command->common);
    on_run(*morph, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
