// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/mesh/deform.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/shuffle.hpp>

#include <memory>
#include <numbers>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct DeformCommand {
    CommonOptions common;
    std::filesystem::path input, output, truth;
    double bend_degrees = 0, twist_degrees = 0;
    DeformOptions options;
    BodyOptions body{.subdivisions = 3};
    std::uint64_t shuffle_seed = 0;  // 0 = do not shuffle
    bool move = false;
};

void run(const DeformCommand& command) {
    if (!command.truth.empty() && command.shuffle_seed == 0)
        throw InvalidInput("--truth needs --shuffle: without it the true map is the identity");
    TriangleMesh mesh =
        command.input == "body" ? make_body(command.body) : load_mesh(command.input, command.common);
    DeformOptions options = command.options;
    options.bend = command.bend_degrees * std::numbers::pi / 180;
    options.twist = command.twist_degrees * std::numbers::pi / 180;
    mesh = deform(mesh, options);
    if (command.move) mesh = move_at_random(mesh, options.seed);
    if (command.shuffle_seed != 0) {
        ShuffleResult shuffled = shuffle(mesh, command.shuffle_seed);
        mesh = std::move(shuffled.mesh);
        if (!command.truth.empty())
            write_vertex_map({std::move(shuffled.shuffled_from_original), mesh.n_vertices()}, command.truth);
    }
    write_mesh(mesh, command.output);
    say(command.common, fmt::format("{} vertices, {} triangles -> {}", mesh.n_vertices(), mesh.n_triangles(),
                                    command.output.string()));
    write_report({{"command", "deform"},
                  {"input", command.input.string()},
                  {"output", command.output.string()},
                  {"vertices", mesh.n_vertices()},
                  {"triangles", mesh.n_triangles()},
                  {"bend_degrees", command.bend_degrees},
                  {"twist_degrees", command.twist_degrees},
                  {"warp", options.warp},
                  {"seed", options.seed},
                  {"moved", command.move},
                  {"shuffle_seed", command.shuffle_seed}},
                 command.common);
}

}  // namespace

void add_deform(CLI::App& program) {
    auto command = std::make_shared<DeformCommand>();
    CLI::App* deform = program.add_subcommand("deform", "Deform a mesh to create test data");
    add_input(*deform, command->common.files, "IN", command->input,
              "Mesh file, or the word 'body' for a built-in figure")
        ->required();
    add_output(*deform, command->common.files, "OUT", command->output, Content::mesh, "Mesh file")
        ->required();
    deform
        ->add_option("--bend", command->bend_degrees,
                     "Bend along the longest axis, in degrees from end to end; -360 to 360")
        ->check(number(-360.0, 360.0))
        ->capture_default_str();
    deform
        ->add_option("--twist", command->twist_degrees,
                     "Twist about the longest axis, in degrees from end to end; -360 to 360")
        ->check(number(-360.0, 360.0))
        ->capture_default_str();
    deform
        ->add_option("--warp", command->options.warp,
                     "Size of a smooth random displacement, as a fraction of the mesh's length; 0 to 0.5")
        ->check(number(0.0, 0.5))
        ->capture_default_str();
    deform->add_option("--seed", command->options.seed, "Random seed for --warp and --move")
        ->check(whole_number(0))
        ->capture_default_str();
    deform
        ->add_option("--subdivisions", command->body.subdivisions,
                     "Subdivisions of the built-in figure; each quadruples its vertices; 0 to 7")
        ->check(whole_number(0, 7))
        ->capture_default_str();
    deform->add_flag("--move", command->move,
                     "Apply a random rotation, translation, and scale from 0.5 to 2");
    deform
        ->add_option("--shuffle", command->shuffle_seed,
                     "Shuffle vertices and triangles with this random seed. Default: off")
        ->check(whole_number(1));
    add_output(*deform, command->common.files, "--truth", command->truth, Content::map,
               "Write the true map to this file: line i = new index of vertex i")
        ->type_name("FILE");
    add_common_options(*deform, command->common);
    on_run(*deform, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
