// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "load_map.hpp"
#include "material_files.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/npy.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/map/invert.hpp>
#include <counterpart/transfer/transfer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace counterpart::cli {
namespace {

struct TransferCommand {
    CommonOptions common;
    MeshInput source, target;
    std::filesystem::path map, inverse, output;
    std::vector<std::string> what;  // empty = all
    std::filesystem::path values, values_output;
    bool labels = false;
    int max_influences = 0;
};

// What can be asked for.
struct TransferKind {
    const char* name;
    bool TransferOptions::*option;
    bool (*held)(const AttributedMesh&);
    bool (*fits)(const std::string& ending);  // besides glTF
};

bool fits_nothing(const std::string& /*ending*/) { return false; }
bool fits_text(const std::string& ending) { return ending == ".obj" || ending == ".ply"; }

// As an OBJ file does, which leaves the rest to another file.
bool names_materials(const AttributedMesh& mesh) {
    return mesh.document == nullptr && !mesh.part_names.empty();
}

constexpr std::array<TransferKind, 6> transfer_kinds = {{
    {"colors", &TransferOptions::colors, [](const AttributedMesh& mesh) { return !mesh.colors.empty(); },
     fits_text},
    {"uv", &TransferOptions::texture_coordinates,
     [](const AttributedMesh& mesh) { return !mesh.texture_coordinates.empty(); }, fits_text},
    {"normals", &TransferOptions::normals,
     [](const AttributedMesh& mesh) { return mesh.normals.values.rows() > 0; }, fits_text},
    {"skin", &TransferOptions::skin, [](const AttributedMesh& mesh) { return mesh.skin.weights.size() > 0; },
     fits_nothing},
    {"morphs", &TransferOptions::morphs, [](const AttributedMesh& mesh) { return !mesh.morphs.empty(); },
     fits_nothing},
    {"texture", &TransferOptions::materials,
     [](const AttributedMesh& mesh) { return has_materials(mesh) || names_materials(mesh); }, fits_nothing},
}};

std::string kinds_held(const AttributedMesh& mesh) {
    std::vector<std::string> names;
    for (const TransferKind& kind : transfer_kinds)
        if (kind.held(mesh)) names.emplace_back(kind.name);
    return names.empty() ? "nothing to transfer" : fmt::format("{}", fmt::join(names, ", "));
}

TransferOptions chosen_options(const TransferCommand& command, const AttributedMesh& source) {
    TransferOptions options{.max_influences = command.max_influences,
                            .n_threads = command.common.threads,
                            .progress = progress_bar("transferring", command.common)};
    const auto asked = [&](const char* name) {
        return std::count(command.what.begin(), command.what.end(), name) > 0;
    };
    for (const TransferKind& kind : transfer_kinds) {
        const bool held = kind.held(source);
        options.*kind.option = held && (command.what.empty() || asked(kind.name));
        if (!held && asked(kind.name)) {
            throw InvalidInput(fmt::format("{} has no {}; it has {}", utf8_name(command.source), kind.name,
                                           kinds_held(source)));
        }
    }
    options.flat_normals = asked("normals");
    // Texture coordinates are of no use without their texture.
    if (options.texture_coordinates && (has_materials(source) || names_materials(source)))
        options.materials = true;
    return options;
}

bool transfers_anything(const TransferOptions& options) {
    return std::any_of(transfer_kinds.begin(), transfer_kinds.end(),
                       [&](const TransferKind& kind) { return options.*kind.option; });
}

std::string in_words(const TransferredAttribute& attribute, Index n_vertices) {
    const Coverage& coverage = attribute.coverage;
    std::string words =
        fmt::format("{}: {} of {} vertices transferred", attribute.name, coverage.transferred, n_vertices);
    const auto add = [&](Index count, const char* what) {
        if (count > 0) words += fmt::format(", {} {}", count, what);
    };
    add(coverage.filled, "filled from their neighbors");
    add(coverage.guessed, "in components without any match, guessed from the nearest match");
    add(attribute.seam_triangles, "triangles at seams");
    add(attribute.moved_vertices, "vertices moved onto a seam");
    add(attribute.without_triangles, "triangles left without it, as the source has none there");
    add(attribute.limited_vertices, "limited to fewer joints");
    add(attribute.unbound_vertices, "not bound to a joint, as in the source");
    return words;
}

Json counts_of(const TransferredAttribute& attribute) {
    return {{"name", attribute.name},
            {"transferred", attribute.coverage.transferred},
            {"filled", attribute.coverage.filled},
            {"guessed", attribute.coverage.guessed},
            {"seam_triangles", attribute.seam_triangles},
            {"vertices_moved_onto_seams", attribute.moved_vertices},
            {"triangles_without", attribute.without_triangles},
            {"joint_limited_vertices", attribute.limited_vertices},
            {"vertices_without_joint", attribute.unbound_vertices}};
}

// What a format cannot hold is refused if it was asked for, else left out and said.
void keep_what_fits(const TransferCommand& command, const AttributedMesh& source, TransferOptions& options) {
    if (is_gltf(command.output)) return;
    const std::string ending = lower_extension(command.output);
    std::vector<std::string> left_out;
    for (const TransferKind& kind : transfer_kinds) {
        const bool names_only = kind.option == &TransferOptions::materials && names_materials(source);
        const bool fits = kind.fits(ending) || (names_only && ending == ".obj");
        if (fits || !(options.*kind.option)) continue;
        if (std::count(command.what.begin(), command.what.end(), kind.name) > 0)
            throw InvalidInput(fmt::format("{}: {} can be written only to .glb or .gltf",
                                           utf8_name(command.output), kind.name));
        options.*kind.option = false;
        left_out.emplace_back(kind.name);
    }
    if (!left_out.empty())
        say(command.common, fmt::format("{} files hold no {}: left out; write to .glb to keep them", ending,
                                        fmt::join(left_out, ", ")));
}

// The map in the direction in which it is given, or that was found, once for all that is transferred.
FoundMap<SurfaceMap> map_of(const TransferCommand& command, const TriangleMesh& source,
                            const TriangleMesh& target) {
    if (!command.inverse.empty())
        return {load_surface_map(command.inverse, {target, source, command.target, command.source},
                                 command.common)};
    return surface_map_or_match(command.map, {source, target, command.source, command.target},
                                command.common);
}

TransferResult transferred(const TransferCommand& command, const AttributedMesh& source,
                           const AttributedMesh& target, const SurfaceMap& map,
                           const TransferOptions& options) {
    return command.inverse.empty() ? transfer(source, target, map, options)
                                   : transfer_through_inverse(source, target, map, options);
}

struct VertexValues {
    Matrix values;
    NpyLayout layout;
};

std::optional<VertexValues> values_of(const TransferCommand& command, Index n_vertices) {
    if (command.values.empty()) return std::nullopt;
    VertexValues given{read_npy(command.values), read_npy_layout(command.values)};
    if (given.values.rows() != n_vertices)
        throw InvalidInput(fmt::format("{}: has {} rows, but {} has {} vertices", utf8_name(command.values),
                                       given.values.rows(), utf8_name(command.source), n_vertices));
    if (given.layout.is_integer && !command.labels)
        say(command.common,
            fmt::format("{} holds whole numbers, which are mixed as numbers between vertices; "
                        "if they are labels, give --labels",
                        utf8_name(command.values)));
    return given;
}

// In the shape that was given; labels also in its type.
void write_values(const Matrix& values, const NpyLayout& layout, bool are_labels,
                  const std::filesystem::path& file) {
    if (layout.n_dimensions != 1) return write_npy(values, file);
    const Vector column = values.col(0);
    const auto fits = [](double value) { return std::abs(value) <= std::numeric_limits<Index>::max(); };
    if (!layout.is_integer || !are_labels || !std::all_of(column.begin(), column.end(), fits))
        return write_npy(column, file);
    std::vector<Index> labels;
    for (const double label : column) labels.push_back(static_cast<Index>(label));
    write_npy(labels, file);
}

// At the target's vertices: weighted means, or of labels the one with most weight.
void transfer_values_file(const TransferCommand& command, const TriangleMesh& source,
                          const TriangleMesh& target, const SurfaceMap& map, const VertexValues& given) {
    SurfaceMap back =
        command.inverse.empty() ? invert(map, source, target, {.n_threads = command.common.threads}) : map;
    back = complete_map(back, target, source).target_from_source;
    if (command.labels) back = surface_map_of(nearest_corners(back, source), source);
    write_values(transfer_values(back, source, given.values), given.layout, command.labels,
                 command.values_output);
    say(command.common, fmt::format("{} x {} values -> {}", target.n_vertices(), given.values.cols(),
                                    utf8_name(command.values_output)));
}

void run(const TransferCommand& command) {
    Stopwatch watch;
    const AttributedMesh source = load_attributed_mesh(command.source, command.common);
    AttributedMesh target = load_attributed_mesh(command.target, command.common);
    watch.lap("read");
    TransferOptions options = chosen_options(command, source);
    keep_what_fits(command, source, options);
    Json report = {{"command", "transfer"},
                   {"source", utf8_name(command.source)},
                   {"target", utf8_name(command.target)},
                   {"output", utf8_name(command.output)},
                   {"vertices", target.mesh.n_vertices()},
                   {"triangles", target.mesh.n_triangles()},
                   {"attributes", Json::array()}};
    const std::optional<VertexValues> values = values_of(command, source.mesh.n_vertices());
    FoundMap<SurfaceMap> found;
    if (transfers_anything(options) || values) found = map_of(command, source.mesh, target.mesh);
    report.update(found.report);
    if (values) transfer_values_file(command, source.mesh, target.mesh, found.map, *values);
    if (transfers_anything(options)) {
        if (const Index n = n_parts(target); options.skin && n > 1)
            say(command.common,
                fmt::format("the {} parts of {} become those of the source, whose skeleton binds "
                            "them: their names and materials are not kept",
                            n, utf8_name(command.target)));
        TransferResult result = transferred(command, source, target, found.map, options);
        watch.lap("transfer");
        for (const Message& message : result.messages) {
            if (message.severity == Severity::notice)
                say(command.common, message.sentence);
            else
                warn(message.sentence);
        }
        for (const TransferredAttribute& attribute : result.attributes) {
            say(command.common, in_words(attribute, target.mesh.n_vertices()));
            report["attributes"].push_back(counts_of(attribute));
        }
        report["texture"] = result.has_materials;
        report["matched_vertices"] = result.n_matched;
        target = std::move(result.content);
    } else {
        say(command.common,
            fmt::format("nothing is transferred; {} has {}", utf8_name(command.source), kinds_held(source)));
    }
    write_attributed_mesh(target, command.output);
    if (options.materials && names_materials(source)) carry_material_files(command.source, command.output);
    watch.lap("write");
    say(command.common,
        fmt::format("{} vertices, {} triangles -> {}{}", target.mesh.n_vertices(), target.mesh.n_triangles(),
                    utf8_name(command.output), caution(found.report)));
    report["seconds"] = to_json(watch.stages());
    write_report(report, command.common);
}

}  // namespace

void add_transfer(CLI::App& program) {
    auto command = std::make_shared<TransferCommand>();
    CLI::App* transfer = program.add_subcommand(
        "transfer", "Transfer colors, texture, skin and morph targets from SOURCE to TARGET");
    add_mesh(*transfer, command->common.files, "SOURCE", "--source-object", command->source,
             "Mesh file with the attributes: .glb, .gltf, .obj or .ply")
        ->required();
    add_mesh(*transfer, command->common.files, "TARGET", "--target-object", command->target,
             "Mesh file that gets them and keeps its shape")
        ->required();
    CLI::Option* map =
        add_input(*transfer, command->common.files, "--map", command->map,
                  "Map from SOURCE to TARGET. Default: match them first, unless they have the same triangles")
            ->type_name("FILE");
    add_input(*transfer, command->common.files, "--inverse", command->inverse,
              "Map from TARGET to SOURCE, instead of --map")
        ->type_name("FILE")
        ->excludes(map);
    add_output(*transfer, command->common.files, "-o,--output", command->output, Content::mesh,
               "Mesh file: .glb or .gltf; .obj and .ply keep colors, uv and normals")
        ->required();
    CLI::Option* values = add_input(
        *transfer, command->common.files, "--values", command->values,
        "Numbers per vertex of SOURCE (.npy), to be transferred as well, in the shape that they have");
    CLI::Option* values_output =
        add_output(*transfer, command->common.files, "--values-output", command->values_output,
                   Content::matrix, "File for the numbers per vertex of TARGET (.npy)");
    values->needs(values_output);
    values_output->needs(values);
    transfer
        ->add_flag("--labels", command->labels,
                   "The numbers are labels: take the nearest, do not mix; whole numbers stay whole")
        ->needs(values);
    std::vector<std::string> names = {"none"};
    for (const TransferKind& kind : transfer_kinds) names.emplace_back(kind.name);
    transfer
        ->add_option("--what", command->what,
                     "What to transfer, separated by commas: colors, uv (with its texture), normals, skin "
                     "(with the skeleton), morphs, texture; or none. Default: everything SOURCE has")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(one_of(names))
        ->type_name("LIST");
    transfer
        ->add_option("--joints", command->max_influences,
                     "Maximum number of joints per vertex, 1 to 64; 0 = as in SOURCE")
        ->check(whole_number(0, 64))
        ->capture_default_str();
    add_common_options(*transfer, command->common);
    on_run(*transfer, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
