// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "known_pairs.hpp"
#include "load_map.hpp"

#include <counterpart/io/landmark_points.hpp>
#include <counterpart/map/carry_points.hpp>

#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct LandmarksCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path points, map, output;
    std::optional<Anatomical> axes{};
};

Points as_rows(const std::vector<Landmark>& landmarks) {
    Points rows(static_cast<Eigen::Index>(landmarks.size()), 3);
    for (std::size_t i = 0; i < landmarks.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = landmarks[i].point;
    return rows;
}

// In the axes of the meshes. Points of a file that says none were set in those of their mesh.
LandmarkPoints points_on_source(const LandmarksCommand& command) {
    LandmarkPoints points = read_landmark_points(command.points);
    if (!command.axes) return points;
    if (points.axes) return read_landmark_points(command.points, command.axes);
    points.axes = command.axes;
    return points;
}

void run(const LandmarksCommand& command) {
    LandmarkPoints points = points_on_source(command);
    require_writable(points, command.output);
    const TriangleMesh source = load_mesh(command.source, command.common);
    const TriangleMesh target = load_mesh(command.target, command.common);
    require_near(points.landmarks, source, "source");
    const FoundMap<SurfaceMap> found =
        surface_map_or_match(command.map, {source, target, command.source, command.target}, command.common);
    const Points carried = carry_points(as_rows(points.landmarks), source, target, found.map);
    std::vector<Landmark> on_target;
    std::vector<std::string> lost;
    for (std::size_t i = 0; i < points.landmarks.size(); ++i) {
        const auto row = carried.row(static_cast<Eigen::Index>(i));
        if (row.hasNaN())
            lost.push_back(points.landmarks[i].name);
        else
            on_target.push_back({points.landmarks[i].name, row});
    }
    for (const std::string& name : lost)
        warn(
            fmt::format("landmark '{}' is left out: the map has no partner for the surface around it", name));
    points.landmarks = std::move(on_target);
    write_landmark_points(points, command.output);
    say(command.common,
        fmt::format("{} of {} landmarks -> {}{}", points.landmarks.size(),
                    points.landmarks.size() + lost.size(), utf8_name(command.output), caution(found.report)));
    Json report = {{"command", "landmarks"}, {"carried", points.landmarks.size()}, {"lost", lost}};
    report.update(found.report);
    write_report(report, command.common);
}

}  // namespace

void add_landmarks(CLI::App& program) {
    auto command = std::make_shared<LandmarksCommand>();
    FileArguments& files = command->common.files;
    CLI::App* landmarks =
        program.add_subcommand("landmarks", "Carry landmarks that were set on SOURCE to TARGET");
    add_mesh(*landmarks, files, "SOURCE", "--source-object", command->source, "Mesh file")->required();
    add_mesh(*landmarks, files, "TARGET", "--target-object", command->target, "Mesh file")->required();
    add_input(*landmarks, files, "POINTS", command->points,
              "Landmarks on SOURCE, in its frame: .mrk.json or .fcsv of 3D Slicer, .json of scalismo, .csv")
        ->required();
    add_output(*landmarks, files, "-o,--output", command->output, Content::landmarks,
               "File for the landmarks on TARGET, of any of these formats, or .tps")
        ->required();
    add_input(*landmarks, files, "--map", command->map,
              "Map from SOURCE to TARGET. Default: match them first, unless they have the same triangles")
        ->type_name("FILE");
    add_landmark_axes(*landmarks, command->axes);
    add_common_options(*landmarks, command->common);
    on_run(*landmarks, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
