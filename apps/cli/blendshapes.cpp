// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/transfer/morph.hpp>

#include <memory>
#include <set>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct BlendshapesCommand {
    CommonOptions common;
    MeshInput base;
    std::filesystem::path output;
    std::vector<std::filesystem::path> shapes;
    bool keep = false;
};

std::string unused_name(const std::string& wanted, const std::vector<MorphTarget>& targets) {
    std::set<std::string> used;
    for (const MorphTarget& target : targets) used.insert(target.name);
    std::string name = wanted;
    for (int number = 2; used.contains(name); ++number) name = fmt::format("{}_{}", wanted, number);
    return name;
}

// A shape is to differ in its form only: scale and place would become part of the blend shape.
void warn_of_another_place(const BlendshapesCommand& command, const TriangleMesh& base, const Points& moved,
                           const std::filesystem::path& file) {
    constexpr double noticeable = 0.05;  // share of the base's size, as in transfer
    const double size = (base.vertices.colwise().maxCoeff() - base.vertices.colwise().minCoeff()).norm();
    const double mean = moved.rowwise().norm().mean();
    if (mean > noticeable * size)
        warn(fmt::format(
            "{}: its vertices are {:.0f} % of the base's size away on average, in another place or "
            "scale: first lay it on the base with 'counterpart align {} {} --model similarity'",
            utf8_name(file), 100 * mean / size, utf8_name(file), utf8_name(command.base)));
}

void run(const BlendshapesCommand& command) {
    if (!is_gltf(command.output))
        throw InvalidInput(
            fmt::format("{}: blend shapes can be written only to .glb or .gltf", utf8_name(command.output)));
    Stopwatch watch;
    AttributedMesh base = load_attributed_mesh(command.base, command.common);
    if (!command.keep) base.morphs.clear();
    Json shapes = Json::array();
    for (const std::filesystem::path& path : command.shapes) {
        const MeshInput file{path};
        const TriangleMesh shape = load_mesh(file, command.common);
        const FoundMap<SurfaceMap> found =
            surface_map_or_match({}, {base.mesh, shape, command.base, file}, command.common);
        const LastPose pose = last_pose(base.mesh, shape, found.map);
        const Points moved = pose.vertices - base.mesh.vertices;
        const std::string name = unused_name(utf8_name(path.stem()), base.morphs);
        base.morphs.push_back({name, moved});
        const double largest = moved.rowwise().norm().maxCoeff();
        say(command.common,
            fmt::format("{}: moves vertices by up to {:.4g}{}{}", name, largest,
                        pose.n_followers > 0
                            ? fmt::format("; {} unmatched vertices follow their neighbors", pose.n_followers)
                            : "",
                        caution(found.report)));
        Json entry = {{"name", name},
                      {"file", utf8_name(file)},
                      {"largest_displacement", largest},
                      {"following_vertices", pose.n_followers}};
        entry.update(found.report);
        shapes.push_back(entry);
        warn_of_another_place(command, base.mesh, moved, file);
    }
    watch.lap("shapes");
    write_attributed_mesh(base, command.output);
    watch.lap("write");
    say(command.common, fmt::format("{} vertices, {} -> {}", base.mesh.n_vertices(),
                                    counted(static_cast<Index>(base.morphs.size()), "blend shape"),
                                    utf8_name(command.output)));
    write_report({{"command", "blendshapes"},
                  {"base", utf8_name(command.base)},
                  {"shapes", shapes},
                  {"seconds", to_json(watch.stages())}},
                 command.common);
}

}  // namespace

void add_blendshapes(CLI::App& program) {
    auto command = std::make_shared<BlendshapesCommand>();
    FileArguments& files = command->common.files;
    CLI::App* blendshapes = program.add_subcommand(
        "blendshapes", "Join many shapes of one face or body into a GLB with named blend shapes");
    add_mesh(*blendshapes, files, "BASE", "--base-object", command->base,
             "Mesh file of the neutral shape, with its attributes")
        ->required();
    add_input(
        *blendshapes, files, "SHAPE", command->shapes,
        "Mesh files of the other shapes, in any vertex order and triangulation; their names become those "
        "of the blend shapes")
        ->required();
    add_output(*blendshapes, files, "-o,--output", command->output, Content::mesh, "Mesh file: .glb or .gltf")
        ->required();
    blendshapes->add_flag("--keep", command->keep, "Keep the blend shapes that BASE has");
    add_common_options(*blendshapes, command->common);
    on_run(*blendshapes, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
