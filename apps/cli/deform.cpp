// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/mesh/shapes.hpp>
#include <counterpart/mesh/variants.hpp>
#include <counterpart/render/visible.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct DeformCommand {
    CommonOptions common;
    MeshInput input;
    std::filesystem::path output, truth;
    double bend_degrees = 0, twist_degrees = 0;
    DeformOptions options;
    BodyOptions body{.subdivisions = 3};
    std::uint64_t shuffle_seed = 0;  // 0 = do not shuffle
    bool move = false;
    double cut_share = 0;
    std::string cut_from = "top", seen_from;
    int holes = 0;
    double hole_radius = 0.1, kept_vertices = 0, glue = 0;
};

// The mesh, and where the vertices of the input went.
struct Derived {
    TriangleMesh mesh;
    std::vector<Index> mesh_from_input;

    explicit Derived(TriangleMesh input) : mesh(std::move(input)) {
        mesh_from_input.resize(static_cast<std::size_t>(mesh.n_vertices()));
        std::iota(mesh_from_input.begin(), mesh_from_input.end(), 0);
    }
    // By a mesh of some of the vertices.
    void replace(TriangleMesh by, const std::vector<Index>& old_from_new) {
        std::vector<Index> new_from_old(static_cast<std::size_t>(mesh.n_vertices()), VertexMap::unmatched);
        for (std::size_t v = 0; v < old_from_new.size(); ++v)
            new_from_old[static_cast<std::size_t>(old_from_new[v])] = static_cast<Index>(v);
        renumber(new_from_old);
        mesh = std::move(by);
    }
    void renumber(const std::vector<Index>& new_from_old) {
        for (Index& v : mesh_from_input)
            if (v != VertexMap::unmatched) v = new_from_old[static_cast<std::size_t>(v)];
    }
};

// Without at most `share` of its vertices, those farthest toward the camera; the plane lies between vertices.
PartOfMesh without_share(const TriangleMesh& mesh, double share, const render::Camera& camera) {
    const Eigen::RowVector3d away = -camera.row(2);
    const Vector height = mesh.vertices * away.transpose();
    std::vector<double> sorted(height.begin(), height.end());
    std::sort(sorted.begin(), sorted.end());
    const double kept = sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size()))];
    const auto first_kept = std::lower_bound(sorted.begin(), sorted.end(), kept);
    const double cut = first_kept == sorted.begin() ? kept - 1 : *std::prev(first_kept);
    return cut_by_plane(mesh, away, 0.5 * (cut + kept));
}

void take_apart(const DeformCommand& command, Derived& derived) {
    const TriangleMesh& mesh = derived.mesh;
    const auto keep = [&](PartOfMesh part) {
        if (part.mesh.n_triangles() == 0)
            throw InvalidInput("nothing is left of the mesh: cut off less, or make fewer or smaller holes");
        derived.replace(std::move(part.mesh), part.whole_from_part);
    };
    std::string up;  // of the whole mesh, also for what is left of it
    if (command.cut_share > 0 || !command.seen_from.empty()) {
        up = render::find_up_axis(mesh);
        say(command.common, fmt::format("up is {}, a guess from the shape", up));
    }
    if (command.cut_share > 0)
        keep(without_share(mesh, command.cut_share,
                           render::find_camera(mesh, {.direction = command.cut_from, .up = up})));
    if (command.holes > 0)
        keep(cut_holes(mesh, command.holes, command.hole_radius * std::sqrt(surface_area(mesh)),
                       command.options.seed));
    if (!command.seen_from.empty())
        keep(part_of(mesh, render::visible_triangles(
                               mesh, render::find_camera(mesh, {.direction = command.seen_from, .up = up}))));
    if (command.kept_vertices > 0) {
        RetriangulateResult other =
            retriangulate(mesh, {.kept_share = command.kept_vertices, .seed = command.options.seed});
        derived.replace(std::move(other.mesh), other.original_from_mesh);
    }
}

void run(const DeformCommand& command) {
    const bool takes_apart = command.cut_share > 0 || command.holes > 0 || !command.seen_from.empty() ||
                             command.kept_vertices > 0 || command.glue > 0;
    if (!command.truth.empty() && command.shuffle_seed == 0 && !takes_apart)
        throw InvalidInput(
            "--truth needs --shuffle, --cut, --holes, --seen-from, --retriangulate or --glue: without them "
            "the true "
            "map is the identity");
    if (command.input.file == "body" && command.input.object)
        throw InvalidInput("--object is of a mesh file: 'body' is one object");
    Derived derived(command.input.file == "body" ? make_body(command.body)
                                                 : load_mesh(command.input, command.common));
    DeformOptions options = command.options;
    options.bend = command.bend_degrees * std::numbers::pi / 180;
    options.twist = command.twist_degrees * std::numbers::pi / 180;
    take_apart(command, derived);
    TriangleMesh& mesh = derived.mesh;
    mesh = deform(mesh, options);
    if (command.glue > 0) {
        FusedMesh fused = fuse(mesh, command.glue * std::sqrt(surface_area(mesh)));
        mesh = std::move(fused.mesh);
        derived.renumber(fused.fused_from_original);
    }
    if (command.move) mesh = move_at_random(mesh, options.seed);
    if (command.shuffle_seed != 0) {
        ShuffleResult shuffled = shuffle(mesh, command.shuffle_seed);
        mesh = std::move(shuffled.mesh);
        derived.renumber(shuffled.shuffled_from_original);
    }
    if (!command.truth.empty())
        write_vertex_map({std::move(derived.mesh_from_input), mesh.n_vertices()}, command.truth);
    write_mesh(mesh, command.output);
    say(command.common, fmt::format("{} vertices, {} triangles -> {}", mesh.n_vertices(), mesh.n_triangles(),
                                    utf8_name(command.output)));
    write_report({{"command", "deform"},
                  {"input", utf8_name(command.input)},
                  {"output", utf8_name(command.output)},
                  {"vertices", mesh.n_vertices()},
                  {"triangles", mesh.n_triangles()},
                  {"bend_degrees", command.bend_degrees},
                  {"twist_degrees", command.twist_degrees},
                  {"warp", options.warp},
                  {"seed", options.seed},
                  {"cut_share", command.cut_share},
                  {"cut_from", command.cut_from},
                  {"holes", command.holes},
                  {"hole_radius", command.hole_radius},
                  {"seen_from", command.seen_from},
                  {"kept_vertices", command.kept_vertices},
                  {"glue", command.glue},
                  {"moved", command.move},
                  {"shuffle_seed", command.shuffle_seed}},
                 command.common);
}

}  // namespace

void add_deform(CLI::App& program) {
    auto command = std::make_shared<DeformCommand>();
    CLI::App* deform = program.add_subcommand("deform", "Deform a mesh to create test data");
    add_mesh(*deform, command->common.files, "IN", "--object", command->input,
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
    deform
        ->add_option("--seed", command->options.seed,
                     "Random seed for --warp, --holes, --retriangulate and --move")
        ->check(whole_number(0))
        ->capture_default_str();
    deform
        ->add_option("--subdivisions", command->body.subdivisions,
                     "Subdivisions of the built-in figure; each quadruples its vertices; 0 to 7")
        ->check(whole_number(0, 7))
        ->capture_default_str();
    const std::string parts = "As a scanner delivers it (all but --glue before it is deformed)";
    deform
        ->add_option("--cut", command->cut_share,
                     "Cut off at most this share of the vertices by a plane; 0 to 0.99")
        ->check(number(0.0, 0.99))
        ->group(parts);
    deform
        ->add_option("--cut-from", command->cut_from,
                     "Where --cut takes them off: front, back, left, right, top, bottom, or "
                     "AZIMUTH,ELEVATION in degrees")
        ->capture_default_str()
        ->needs("--cut")
        ->group(parts);
    deform->add_option("--holes", command->holes, "Cut this many holes at random; 0 to 1000")
        ->check(whole_number(0, 1000))
        ->group(parts);
    deform
        ->add_option("--hole-radius", command->hole_radius,
                     "Of the holes, in units of the square root of the area; 0 to 1")
        ->check(number(0.0, 1.0))
        ->capture_default_str()
        ->needs("--holes")
        ->group(parts);
    deform
        ->add_option("--seen-from", command->seen_from,
                     "Keep what a camera sees from there: a direction as of --cut-from")
        ->group(parts);
    deform
        ->add_option("--retriangulate", command->kept_vertices,
                     "Other triangles, with this share of the vertices; 0.05 to 1")
        ->check(number(0.05, 1.0))
        ->group(parts);
    deform
        ->add_option(
            "--glue", command->glue,
            "Last of all, fuse surfaces that come nearer to each other than this, with new triangles "
            "of this size, in units of the square root of the area; the mesh must be closed; 0 to 0.2")
        ->check(number(0.0, 0.2))
        ->group(parts);
    deform->add_flag("--move", command->move,
                     "Apply a random rotation, translation, and scale from 0.5 to 2");
    deform
        ->add_option("--shuffle", command->shuffle_seed,
                     "Shuffle vertices and triangles with this random seed. Default: off")
        ->check(whole_number(1));
    add_output(*deform, command->common.files, "--truth", command->truth, Content::map,
               "Write the true map to this file: line i = new index of vertex i, -1 if it is gone")
        ->type_name("FILE");
    add_common_options(*deform, command->common);
    on_run(*deform, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
