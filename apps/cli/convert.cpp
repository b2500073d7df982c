// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "material_files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/mesh/weld.hpp>

#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ConvertCommand {
    CommonOptions common;
    MeshInput input;
    std::filesystem::path output;
    double weld_distance = -1;
    int cells = 0;
};

void write_solid(const TetrahedralMesh& mesh, const ConvertCommand& command) {
    write_tetrahedral_mesh(mesh, command.output);
    say(command.common, fmt::format("{} vertices, {} tetrahedra -> {}", mesh.n_vertices(),
                                    mesh.n_tetrahedra(), utf8_name(command.output)));
    write_report({{"command", "convert"},
                  {"input", utf8_name(command.input)},
                  {"output", utf8_name(command.output)},
                  {"vertices", mesh.n_vertices()},
                  {"tetrahedra", mesh.n_tetrahedra()}},
                 command.common);
}

void run(const ConvertCommand& command) {
    if (command.cells > 0 && !holds_tetrahedra(command.output))
        throw InvalidInput(fmt::format(
            "--fill makes a solid, which {} files do not hold: name OUT .msh, .mesh or .vtk, or leave it out",
            lower_extension(command.output)));
    if (holds_tetrahedra(command.output)) {
        if (command.cells > 0)
            return write_solid(fill_with_tetrahedra(load_mesh(command.input, command.common), command.cells),
                               command);
        if (const auto solid = load_solid(command.input, command.common)) return write_solid(*solid, command);
    }
    AttributedMesh content = load_attributed_mesh(command.input, command.common);
    if (command.weld_distance >= 0) {
        TriangleMesh welded = weld(content.mesh, {.distance = command.weld_distance}).mesh;
        say(command.common, fmt::format("welded {} vertices into {}; attributes are dropped",
                                        content.mesh.n_vertices(), welded.n_vertices()));
        content = {};
        content.mesh = std::move(welded);
    }
    write_attributed_mesh(content, command.output);
    if (!content.part_names.empty()) carry_material_files(command.input, command.output);
    const TriangleMesh& mesh = content.mesh;
    say(command.common, fmt::format("{} vertices, {} triangles -> {}", mesh.n_vertices(), mesh.n_triangles(),
                                    utf8_name(command.output)));
    write_report({{"command", "convert"},
                  {"input", utf8_name(command.input)},
                  {"output", utf8_name(command.output)},
                  {"vertices", mesh.n_vertices()},
                  {"triangles", mesh.n_triangles()}},
                 command.common);
}

}  // namespace

void add_convert(CLI::App& program) {
    auto command = std::make_shared<ConvertCommand>();
    CLI::App* convert =
        program.add_subcommand("convert", "Convert a mesh to another format, keeping the vertex order");
    add_mesh(*convert, command->common.files, "IN", "--object", command->input, "Mesh file")->required();
    add_output(*convert, command->common.files, "OUT", command->output, Content::mesh,
               "Mesh file; format from the file extension")
        ->required();
    convert
        ->add_option("--weld", command->weld_distance,
                     "Merge vertices up to this far apart, in mesh units; alone: 0, only coincident ones. "
                     "Default: off")
        ->type_name("[LENGTH]")
        ->check(non_negative());
    convert
        ->add_option(
            "--fill", command->cells,
            "To .msh, .mesh or .vtk: fill a closed surface with cubes of six tetrahedra, this many along "
            "its longest side")
        ->check(whole_number(1, 256));
    add_common_options(*convert, command->common);
    on_run(*convert, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
