// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "commands.hpp"
#include "console.hpp"
#include "judgment.hpp"
#include "match_exact.hpp"

#include <counterpart/align/fit_surface.hpp>
#include <counterpart/base/errors.hpp>
#include <counterpart/base/progress.hpp>
#include <counterpart/io/file.hpp>
#include <counterpart/io/obj_reorder.hpp>
#include <counterpart/map/surface_map.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>
#include <counterpart/match/place.hpp>
#include <counterpart/match/volume.hpp>
#include <counterpart/transfer/reorder.hpp>

#include <memory>
#include <optional>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

struct ReorderCommand {
    CommonOptions common;
    ExactOptions options;
    bool allow_differences = false;
    MeshInput source, target;
    std::filesystem::path output;
};

bool is_obj(const std::filesystem::path& file) { return lower_extension(file) == ".obj"; }

// What a report has besides the messages and what follows from them.
struct Reordered {
    Index n_vertices = 0;
    std::vector<std::string> summary{};
    Json details = Json::object();
    std::vector<StageTime> stages{};
};

void report(const ReorderCommand& command, const MeshPair& pair, const std::vector<Message>& messages,
            const Reordered& done) {
    const Judgment judgment{messages, {}};
    say_verdict(command.common, judgment, pair);
    for (const std::string& line : done.summary) say(command.common, line);
    say_messages(command.common, messages, pair);
    say(command.common, fmt::format("{} vertices in the order of {} -> {}", done.n_vertices,
                                    utf8_name(command.source), utf8_name(command.output)));
    Json json{
        {"command", "reorder"}, {"source", utf8_name(command.source)}, {"target", utf8_name(command.target)}};
    json.update(judgment.report());
    json.update({{"vertices", done.n_vertices}, {"messages", to_json(messages)}});
    json.update(done.details);
    if (!done.stages.empty()) json["seconds"] = to_json(done.stages);
    write_report(json, command.common);
}

void run_solids(const ReorderCommand& command, TetrahedralMesh source, const TetrahedralMesh& target) {
    if (command.allow_differences)
        throw InvalidInput("--allow-differences is for surfaces: the order of solids is restored as a whole");
    const VolumeResult match = match_volume(source, target,
                                            {.method = MatchMethod::exact,
                                             .allow_mirror = command.options.allow_mirror,
                                             .n_threads = command.common.threads});
    if (!match.identical)
        throw InvalidInput("the solids have different connectivity (" + match.difference +
                           "), so the order cannot be restored");
    source.vertices = target.vertices(match.target_from_source.image(), Eigen::all).eval();
    if (match.mirrored) source.tetrahedra.col(2).swap(source.tetrahedra.col(3));
    write_tetrahedral_mesh(source, command.output);
    const TriangleMesh source_faces = all_faces(source), target_faces = all_faces(target);
    report(command, {source_faces, target_faces, command.source, command.target}, match.messages,
           {source.n_vertices()});
}

std::string why_not(const ReorderCommand& command, const TriangleMesh& source, const TriangleMesh& target,
                    const std::string& difference) {
    const std::string advice =
        command.options.weld_distance < 0
            ? welding_advice(source, target, utf8_name(command.source), utf8_name(command.target))
            : std::string();
    return fmt::format(
        "the meshes have different connectivity ({}), so the order cannot be restored; "
        "{}{}--allow-differences "
        "restores what both have, and 'fit {} {}' lays the mesh of the first on the surface of the second",
        difference, advice, advice.empty() ? "" : "; ", utf8_name(command.source), utf8_name(command.target));
}

// Where the vertices of both meshes lie at the same places, whatever triangles join them.
std::optional<PlaceResult> at_same_places(const TriangleMesh& source, const TriangleMesh& target,
                                          const ReorderCommand& command) {
    try {
        PlaceResult found = match_place(source, target, {.n_threads = command.common.threads});
        if (found.same_vertices) return found;
    } catch (const UnsuitableMesh&) {  // without area: no place shows
    }
    return std::nullopt;
}

// The source's mesh: its vertices at the target's places, which its own tell.
void run_at_same_places(const ReorderCommand& command, AttributedMesh source, const TriangleMesh& target,
                        const PlaceResult& places, Stopwatch& watch) {
    for (Index v = 0; v < source.mesh.n_vertices(); ++v)
        if (places.target_from_source[v] != VertexMap::unmatched)
            source.mesh.vertices.row(v) = target.vertices.row(places.target_from_source[v]);
    write_attributed_mesh(source, command.output);
    watch.lap("write");
    report(command, {source.mesh, target, command.source, command.target},
           {{MessageCode::same_places, Severity::notice, places.sentence}},
           {source.mesh.n_vertices(), {}, Json::object(), watch.stages()});
}

// The source's mesh in the target's shape: what both have is at the target's places, the rest of the source
// goes with what surrounds it, and the rest of the target is left out.
void run_with_differences(const ReorderCommand& command, AttributedMesh source, const TriangleMesh& target,
                          Stopwatch& watch) {
    const MeshDifferences shared =
        find_differences(source.mesh, target, {.n_threads = command.common.threads});
    if (count_matched(shared.target_from_source) < 3) throw InvalidInput(shared.summary);
    const MatchOutcome outcome = differences_outcome({source.mesh, target, command.common, {}}, shared);
    watch.lap("differences");
    Points places = fit_surface(source.mesh, target, surface_map_of(shared.target_from_source, target),
                                {.n_threads = command.common.threads})
                        .vertices;
    for (Index v = 0; v < shared.target_from_source.source_size(); ++v)
        if (shared.target_from_source[v] != VertexMap::unmatched)
            places.row(v) = target.vertices.row(shared.target_from_source[v]);
    watch.lap("fit");
    source.mesh.vertices = std::move(places);
    source.normals = {};
    write_attributed_mesh(source, command.output);
    watch.lap("write");
    std::vector<Message> messages = shared.messages;
    const std::vector<Index>& others = shared.source_vertices;
    if (!others.empty() || !shared.uncertain.empty())
        messages.push_back(
            {MessageCode::filled_vertices,
             Severity::caution,
             fmt::format("{} of {} vertices are not in {} and go with those around them, {} are "
                         "uncertain",
                         others.size(), source.mesh.n_vertices(), utf8_name(command.target),
                         shared.uncertain.size()),
             {Subject::map, others}});
    report(command, {source.mesh, target, command.source, command.target}, messages,
           {source.mesh.n_vertices(), outcome.summary, outcome.details, watch.stages()});
}

void run(const ReorderCommand& command) {
    if (auto solids = load_solids(command.source, command.target, command.common))
        return run_solids(command, std::move(solids->first), solids->second);
    Stopwatch watch;
    const AttributedMesh source_content = load_attributed_mesh(command.source, command.common);
    const AttributedMesh target_content = load_attributed_mesh(command.target, command.common);
    const TriangleMesh& source = source_content.mesh;
    const TriangleMesh& target = target_content.mesh;
    watch.lap("read");
    ExactResult match = match_exact(source, target, command.options);
    watch.lap("match");
    if (!match.identical) {
        if (!command.allow_differences)
            throw InvalidInput(why_not(command, source, target, match.difference));
        if (const auto places = at_same_places(source, target, command))
            return run_at_same_places(command, source_content, target, *places, watch);
        return run_with_differences(command, source_content, target, watch);
    }
    if (match.mirrored) {
        write_attributed_mesh(
            turned_inside_out(reorder(source_content, target_content, match.target_from_source,
                                      match.target_corner_from_source)),
            command.output);
        match.messages.push_back(
            {MessageCode::turned_inside_out, Severity::notice,
             "its faces are wound the other way than the source's, so that the outside stays out"});
    } else if (is_obj(command.target) && is_obj(command.output) && !command.source.object &&
               !command.target.object) {
        const std::string shape = read_whole_file(command.target);
        write_file(
            is_obj(command.source)
                ? reorder_obj(read_whole_file(command.source), shape, match.target_from_source,
                              source.triangles, match.target_corner_from_source)
                : reorder_obj(source, shape, match.target_from_source, match.target_corner_from_source),
            command.output);
    } else {
        write_attributed_mesh(reorder(source_content, target_content, match.target_from_source,
                                      match.target_corner_from_source),
                              command.output);
    }
    watch.lap("write");
    report(command, {source, target, command.source, command.target}, match.messages,
           {source.n_vertices(), {}, Json::object(), watch.stages()});
}

}  // namespace

void add_reorder(CLI::App& program) {
    auto command = std::make_shared<ReorderCommand>();
    CLI::App* reorder = program.add_subcommand(
        "reorder", "Write TARGET with the vertex order and faces of SOURCE (same connectivity)");
    add_mesh(*reorder, command->common.files, "SOURCE", "--source-object", command->source,
             "Mesh file with the wanted order")
        ->required();
    add_mesh(*reorder, command->common.files, "TARGET", "--target-object", command->target,
             "Mesh file with the wanted shape")
        ->required();
    add_output(
        *reorder, command->common.files, "-o,--output", command->output, Content::mesh,
        "Mesh file. From whole .obj to .obj, positions keep their text and corners their texture coordinates "
        "and normals; polygons, groups and materials are those of SOURCE. glTF gets the attributes, "
        "materials and skeleton of TARGET, or of SOURCE if TARGET has none")
        ->required();
    reorder->add_flag("--allow-mirror", command->options.allow_mirror,
                      "Also consider orientation-reversing matches");
    reorder->add_flag(
        "--allow-differences", command->allow_differences,
        "Where the meshes differ: vertices that both have take the places of TARGET's, the others "
        "of SOURCE go with those around them, with the attributes of SOURCE");
    reorder
        ->add_option("--weld", command->options.weld_distance,
                     "First merge vertices up to this far apart, in mesh units; alone: 0. Default: off")
        ->type_name("[LENGTH]")
        ->check(non_negative());
    add_common_options(*reorder, command->common);
    on_run(*reorder, command->common, [command] { run(*command); });
}

}  // namespace counterpart::cli
