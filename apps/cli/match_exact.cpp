// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_exact.hpp"

#include "match_methods.hpp"

#include <counterpart/io/map_file.hpp>
#include <counterpart/match/difference.hpp>
#include <counterpart/match/exact.hpp>

#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

constexpr std::size_t most_listed = 10;  // of each kind on the screen; the report has all

Json to_json(const Count& count) {
    Json json = {{"text", to_string(count)}, {"lower_bound", count.is_lower_bound}};
    if (count.number) json["number"] = *count.number;
    if (std::isfinite(count.log10)) json["log10"] = count.log10;
    return json;
}

Json position(const TriangleMesh& mesh, Index vertex) {
    return {mesh.vertices(vertex, 0), mesh.vertices(vertex, 1), mesh.vertices(vertex, 2)};
}

Json vertices_to_json(const TriangleMesh& mesh, const std::vector<Index>& vertices) {
    Json json = Json::array();
    for (const Index v : vertices) json.push_back({{"vertex", v}, {"position", position(mesh, v)}});
    return json;
}

Json triangles_to_json(const TriangleMesh& mesh, const std::vector<Index>& triangles) {
    Json json = Json::array();
    for (const Index t : triangles) {
        const Eigen::RowVector3d center =
            (mesh.vertices.row(mesh.triangles(t, 0)) + mesh.vertices.row(mesh.triangles(t, 1)) +
             mesh.vertices.row(mesh.triangles(t, 2))) /
            3;
        json.push_back({{"triangle", t},
                        {"vertices", {mesh.triangles(t, 0), mesh.triangles(t, 1), mesh.triangles(t, 2)}},
                        {"center", {center[0], center[1], center[2]}}});
    }
    return json;
}

Json to_json(const MeshDifference& difference, const TriangleMesh& source, const TriangleMesh& target) {
    Json spots = Json::array();
    for (const Edit& edit : difference.edits) {
        spots.push_back({{"sentence", edit.sentence},
                         {"source_triangles", edit.source_triangles},
                         {"target_triangles", edit.target_triangles},
                         {"source_vertices", edit.source_vertices},
                         {"target_vertices", edit.target_vertices}});
    }
    return {{"matched_vertices", count_matched(difference.target_from_source)},
            {"matched_triangles", difference.n_matched_triangles},
            {"largest_matched_part_triangles", difference.largest_part},
            {"uncertain_source_vertices", vertices_to_json(source, difference.uncertain)},
            {"source_only_vertices", vertices_to_json(source, difference.source_vertices)},
            {"target_only_vertices", vertices_to_json(target, difference.target_vertices)},
            {"source_only_triangles", triangles_to_json(source, difference.source_triangles)},
            {"target_only_triangles", triangles_to_json(target, difference.target_triangles)},
            {"edits", spots}};
}

void write_alternatives(const std::vector<VertexMap>& maps, const std::string& prefix,
                        MatchOutcome& outcome) {
    for (std::size_t i = 0; i < maps.size(); ++i)
        write_vertex_map(maps[i], fmt::format("{}{}.txt", prefix, i + 1));
    outcome.messages.push_back(
        fmt::format("wrote {} symmetric alternatives to {}1.txt ...", maps.size(), prefix));
    if (maps.empty()) outcome.messages.back() = "there is no symmetric alternative";
}

void run_difference(const MatchInput& input, const ExactArguments& arguments, const std::string& first,
                    MatchOutcome& outcome) {
    const MeshDifference difference = find_differences(input.source, input.target);
    outcome.messages.push_back("the connectivity differs: " + first);
    outcome.messages.push_back(difference.summary);
    for (std::size_t i = 0; i < std::min(most_listed, difference.edits.size()); ++i)
        outcome.messages.push_back("  " + difference.edits[i].sentence);
    if (difference.edits.size() > most_listed)
        outcome.messages.push_back(
            fmt::format("  and {} more; --report lists all", difference.edits.size() - most_listed));
    outcome.details["first_difference"] = first;
    outcome.details["difference"] = to_json(difference, input.source, input.target);
    if (arguments.allow_differences) {
        outcome.target_from_source = difference.target_from_source;
    } else {
        outcome.failure =
            "the two meshes are not connected alike; --allow-differences writes the map of what they share";
    }
}

}  // namespace

MatchOutcome exact_outcome(const MatchInput& input, const ExactArguments& arguments, ExactResult result) {
    MatchOutcome outcome;
    outcome.details = {{"identical", result.identical}};
    if (!result.identical) {
        run_difference(input, arguments, result.difference, outcome);
        return outcome;
    }
    Json equal = Json::array();
    for (const EqualIslands& islands : result.interchangeable) {
        equal.push_back({{"triangles", islands.n_triangles},
                         {"source_vertices", islands.source},
                         {"target_vertices", islands.target}});
    }
    outcome.details.update(Json{{"path", result.path == ExactPath::surface ? "surface" : "patches"},
                                {"islands", result.n_islands},
                                {"automorphisms", to_json(result.automorphisms)},
                                {"mirror_automorphisms", to_json(result.mirror_automorphisms)},
                                {"interchangeable_islands", equal},
                                {"reversed_triangles", result.reversed_triangles},
                                {"winding_reversed", result.winding_reversed},
                                {"mirrored", result.mirrored}});
    outcome.messages = result.notices;
    outcome.target_from_source = std::move(result.target_from_source);
    if (!arguments.alternatives.empty())
        write_alternatives(result.alternatives, arguments.alternatives, outcome);
    return outcome;
}

MatchMethod add_exact_method(CLI::App& match, const std::shared_ptr<ExactArguments>& arguments) {
    match.add_flag(
        "--allow-differences", arguments->allow_differences,
        "exact: where the connectivity differs, write the map of what the meshes share, the rest -1");
    match.add_flag("--allow-mirror", arguments->options.allow_mirror,
                   "exact: geometry may choose a match that turns the surface over");
    match
        .add_option("--weld", arguments->options.weld_distance,
                    "exact: first weld vertices up to this far apart, mesh units, from 0; alone: 0")
        ->expected(0, 1)
        ->default_str("off")
        ->check(CLI::NonNegativeNumber);
    match
        .add_option("--symmetric-alternatives", arguments->alternatives,
                    "exact: write the other matches of a symmetric mesh to PREFIX1.txt, PREFIX2.txt, ...")
        ->type_name("PREFIX");
    match
        .add_option("--max-alternatives", arguments->max_alternatives, "exact: how many of them, 1 to 10000")
        ->check(CLI::Range(1, 10'000))
        ->capture_default_str();
    return {"exact", "same connectivity: the match is a fact of the graph, any vertex order, any pose",
            [arguments](const MatchInput& input) {
                arguments->prepare();
                return exact_outcome(input, *arguments,
                                     match_exact(input.source, input.target, arguments->options));
            }};
}

}  // namespace counterpart::cli
