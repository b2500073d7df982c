// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/stopwatch.hpp>
#include <counterpart/io/atomic_file.hpp>
#include <counterpart/io/obj_reorder.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ReorderCommand {
    CommonOptions common;
    ExactOptions options;
    std::filesystem::path source, target, output;
};

bool is_obj(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".obj";
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// Only how many vertices there are and what triangles they make.
std::string obj_faces(const TriangleMesh& mesh) {
    std::string text;
    for (Index v = 0; v < mesh.n_vertices(); ++v) text += "v 0 0 0\n";
    for (Index t = 0; t < mesh.n_triangles(); ++t)
        text += fmt::format("f {} {} {}\n", mesh.triangles(t, 0) + 1, mesh.triangles(t, 1) + 1,
                            mesh.triangles(t, 2) + 1);
    return text;
}

void run(const ReorderCommand& command) {
    Stopwatch watch;
    const AttributedMesh source_content = load_attributed_mesh(command.source, command.common);
    const AttributedMesh target_content = load_attributed_mesh(command.target, command.common);
    const TriangleMesh& source = source_content.mesh;
    const TriangleMesh& target = target_content.mesh;
    watch.lap("read");
    const ExactResult match = match_exact(source, target, command.options);
    watch.lap("match");
    if (!match.identical) {
        throw InvalidInput(
            "the two meshes are not connected alike (" + match.difference +
            "), so there is no order to restore; 'match --method exact' tells where they differ");
    }
    for (const std::string& notice : match.notices) say(command.common, notice);
    if (is_obj(command.target) && is_obj(command.output)) {
        const std::string faces = is_obj(command.source) ? bytes_of(command.source) : obj_faces(source);
        write_file(reorder_obj(faces, bytes_of(command.target), match.target_from_source, source.triangles,
                               match.target_corner_from_source),
                   command.output);
    } else {
        write_attributed_mesh(reorder(source_content, target_content, match.target_from_source,
                                      match.target_corner_from_source),
                              command.output);
    }
    watch.lap("write");
    say(command.common, fmt::format("{} vertices in the order of {} -> {}", source.n_vertices(),
                                    command.source.string(), command.output.string()));
    write_report({{"command", "reorder"},
                  {"source", command.source.string()},
                  {"target", command.target.string()},
                  {"vertices", source.n_vertices()},
                  {"messages", match.notices},
                  {"seconds", to_json(watch.stages())}},
                 command.common);
}

}  // namespace

void add_reorder(CLI::App& program) {
    auto command = std::make_shared<ReorderCommand>();
    CLI::App* reorder = program.add_subcommand(
        "reorder", "Write TARGET's shape with the vertex order and the faces of SOURCE (same connectivity)");
    reorder->add_option("SOURCE", command->source, "Mesh file whose order is wanted")->required();
    reorder->add_option("TARGET", command->target, "Mesh file whose shape is wanted")->required();
    reorder
        ->add_option("-o,--output", command->output,
                     "Mesh file; from .obj to .obj positions keep their text, texture coordinates and "
                     "normals their corners, polygons, groups and materials are the source's. glTF has the "
                     "target's attributes, materials and skeleton, or the source's if the target is bare")
        ->required();
    reorder->add_flag("--allow-mirror", command->options.allow_mirror,
                      "Geometry may choose a match that turns the surface over");
    reorder
        ->add_option("--weld", command->options.weld_distance,
                     "First weld vertices up to this far apart, mesh units, from 0; alone: 0")
        ->expected(0, 1)
        ->default_str("off")
        ->check(CLI::NonNegativeNumber);
    add_common_options(*reorder, command->common);
    reorder->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
