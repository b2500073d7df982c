// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/stopwatch.hpp>
#include <counterpart/io/gltf_materials.hpp>
#include <counterpart/transfer/invert.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

struct TransferCommand {
    CommonOptions common;
    std::filesystem::path source, target, map, inverse, output;
    std::vector<std::string> what;  // empty = all
    int max_influences = 0;
};

// What can be asked for.
struct TransferKind {
    const char* name;
    bool TransferOptions::*option;
    bool (*held)(const AttributedMesh&);
};
constexpr std::array<TransferKind, 6> transfer_kinds = {{
    {"colors", &TransferOptions::colors, [](const AttributedMesh& mesh) { return !mesh.colors.empty(); }},
    {"uv", &TransferOptions::texture_coordinates,
     [](const AttributedMesh& mesh) { return !mesh.texture_coordinates.empty(); }},
    {"normals", &TransferOptions::normals,
     [](const AttributedMesh& mesh) { return mesh.normals.values.rows() > 0; }},
    {"weights", &TransferOptions::skin,
     [](const AttributedMesh& mesh) { return mesh.skin.weights.size() > 0; }},
    {"morphs", &TransferOptions::morphs, [](const AttributedMesh& mesh) { return !mesh.morphs.empty(); }},
    {"texture", &TransferOptions::material, has_materials},
}};

std::string kinds_held(const AttributedMesh& mesh) {
    std::vector<std::string> names;
    for (const TransferKind& kind : transfer_kinds)
        if (kind.held(mesh)) names.emplace_back(kind.name);
    return names.empty() ? "nothing that could be carried" : fmt::format("{}", fmt::join(names, ", "));
}

TransferOptions chosen_options(const TransferCommand& command, const AttributedMesh& source) {
    TransferOptions options{.max_influences = command.max_influences, .n_threads = command.common.threads};
    const auto asked = [&](const char* name) {
        return std::count(command.what.begin(), command.what.end(), name) > 0;
    };
    for (const TransferKind& kind : transfer_kinds) {
        const bool held = kind.held(source);
        options.*kind.option = held && (command.what.empty() || asked(kind.name));
        if (!held && asked(kind.name)) {
            throw InvalidInput(fmt::format("{} has no {}; it has {}", command.source.string(), kind.name,
                                           kinds_held(source)));
        }
    }
    // Texture coordinates are of no use without their texture.
    if (options.texture_coordinates && has_materials(source)) options.material = true;
    return options;
}

bool carries_anything(const TransferOptions& options) {
    return std::any_of(transfer_kinds.begin(), transfer_kinds.end(),
                       [&](const TransferKind& kind) { return options.*kind.option; });
}

SurfaceMap map_to_source(const TransferCommand& command, const TriangleMesh& source,
                         const TriangleMesh& target) {
    if (!command.inverse.empty()) return load_surface_map(command.inverse, target, source, command.common);
    return with_inverse(load_surface_map(command.map, source, target, command.common), source, target,
                        {.n_threads = command.common.threads})
        .source_from_target;
}

// A skeleton is not moved.
void warn_of_another_place(const SurfaceMap& source_from_target, const TriangleMesh& source,
                           const TriangleMesh& target) {
    const Points images = image_positions(source_from_target, source);
    double sum = 0;
    for (Index v = 0; v < target.n_vertices(); ++v)
        if (source_from_target[v].matched()) sum += (images.row(v) - target.vertices.row(v)).norm();
    const double size = (source.vertices.colwise().maxCoeff() - source.vertices.colwise().minCoeff()).norm();
    const double share = sum / std::max<Index>(count_matched(source_from_target), 1) / size;
    constexpr double noticeable = 0.05;
    if (share > noticeable) {
        warn(
            fmt::format("TARGET lies {:.0f} % of SOURCE's size away from it on average, and the skeleton "
                        "stays where SOURCE has it: bring TARGET into SOURCE's bind pose and place first",
                        100 * share));
    }
}

std::string in_words(const TransferredAttribute& attribute, Index n_vertices) {
    const Coverage& coverage = attribute.coverage;
    std::string words =
        fmt::format("{}: {} of {} vertices carried", attribute.name, coverage.carried, n_vertices);
    const auto add = [&](Index count, const char* what) {
        if (count > 0) words += fmt::format(", {} {}", count, what);
    };
    add(coverage.filled, "filled in from their neighbours");
    add(coverage.guessed, "in parts without any match, guessed from the nearest match");
    add(attribute.seam_triangles, "triangles at seams");
    add(attribute.moved_vertices, "vertices moved onto a seam");
    add(attribute.without_triangles, "triangles without, as the source has none there");
    add(attribute.limited_vertices, "limited to fewer joints");
    add(attribute.unbound_vertices, "without a joint, as in the source");
    return words;
}

Json counts_of(const TransferredAttribute& attribute) {
    return {{"name", attribute.name},
            {"carried", attribute.coverage.carried},
            {"filled", attribute.coverage.filled},
            {"guessed", attribute.coverage.guessed},
            {"seam_triangles", attribute.seam_triangles},
            {"vertices_moved_onto_seams", attribute.moved_vertices},
            {"triangles_without", attribute.without_triangles},
            {"joint_limited_vertices", attribute.limited_vertices},
            {"vertices_without_joint", attribute.unbound_vertices}};
}

void require_output_format(const std::filesystem::path& output) {
    const std::string extension = output.extension().string();
    if (extension != ".glb" && extension != ".gltf") {
        throw InvalidInput(
            fmt::format("{}: what is carried can be kept in .glb and .gltf files only", output.string()));
    }
}

void run(const TransferCommand& command) {
    Stopwatch watch;
    const AttributedMesh source = load_attributed_mesh(command.source, command.common);
    AttributedMesh target = load_attributed_mesh(command.target, command.common);
    watch.lap("read");
    const TransferOptions options = chosen_options(command, source);
    Json report = {{"command", "transfer"},
                   {"source", command.source.string()},
                   {"target", command.target.string()},
                   {"output", command.output.string()},
                   {"vertices", target.mesh.n_vertices()},
                   {"triangles", target.mesh.n_triangles()},
                   {"attributes", Json::array()}};
    if (carries_anything(options)) {
        require_output_format(command.output);
        const SurfaceMap source_from_target = map_to_source(command, source.mesh, target.mesh);
        report["matched_vertices"] = count_matched(source_from_target);
        watch.lap("map");
        if (options.skin) warn_of_another_place(source_from_target, source.mesh, target.mesh);
        TransferResult result = transfer_attributes(source_from_target, source, target, options);
        watch.lap("transfer");
        for (const TransferredAttribute& attribute : result.attributes) {
            say(command.common, in_words(attribute, target.mesh.n_vertices()));
            report["attributes"].push_back(counts_of(attribute));
        }
        report["texture"] = options.material;
        if (options.material && !options.skin)
            result.content = with_materials(result.content, source, result.source_parts);
        if (options.skin && !options.material)  // the file is the source's now
            result.content = with_materials(result.content, target, target.parts);
        target = std::move(result.content);
    } else {
        say(command.common,
            fmt::format("nothing is carried; {} has {}", command.source.string(), kinds_held(source)));
    }
    write_attributed_mesh(target, command.output);
    watch.lap("write");
    say(command.common, fmt::format("{} vertices, {} triangles -> {}", target.mesh.n_vertices(),
                                    target.mesh.n_triangles(), command.output.string()));
    report["seconds"] = to_json(watch.stages());
    write_report(report, command.common);
}

}  // namespace

void add_transfer(CLI::App& program) {
    auto command = std::make_shared<TransferCommand>();
    CLI::App* transfer =
        program.add_subcommand("transfer", "Write TARGET with the colours, texture, skin, morphs of SOURCE");
    transfer
        ->add_option("SOURCE", command->source,
                     "Mesh file whose attributes are wanted: .glb, .gltf, .obj or .ply")
        ->required();
    transfer->add_option("TARGET", command->target, "Mesh file whose shape is kept")->required();
    CLI::Option* map =
        transfer
            ->add_option("--map", command->map,
                         "Map from SOURCE to TARGET; without any vertex i of SOURCE is vertex i of TARGET")
            ->type_name("FILE");
    transfer->add_option("--inverse", command->inverse, "Instead: map from TARGET to SOURCE")
        ->type_name("FILE")
        ->excludes(map);
    transfer->add_option("-o,--output", command->output, "Mesh file: .glb or .gltf")->required();
    std::vector<std::string> names = {"none"};
    for (const TransferKind& kind : transfer_kinds) names.emplace_back(kind.name);
    transfer
        ->add_option("--what", command->what,
                     "What to carry, with commas between: colors, uv (with its texture), normals, weights "
                     "(with the skeleton), morphs, texture; or none. Default: all that SOURCE has")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::IsMember(names))
        ->type_name("LIST");
    transfer
        ->add_option("--joints", command->max_influences,
                     "Joints per vertex at most, 1 to 64; 0 = as many as SOURCE has room for")
        ->check(CLI::Range(0, 64))
        ->capture_default_str();
    add_common_options(*transfer, command->common);
    transfer->callback([command] { run(*command); });
}

}  // namespace counterpart::cli
