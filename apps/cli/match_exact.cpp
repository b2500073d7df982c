// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match_exact.hpp"

#include "match_methods.hpp"

#include <counterpart/io/map_file.hpp>
#include <counterpart/match/compare.hpp>
#include <counterpart/match/differences.hpp>
#include <counterpart/match/exact.hpp>

#include <cmath>
#include <memory>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

constexpr std::size_t max_listed = 10;  // edits on the screen; the report has all

Json count_to_json(const Count& count) {
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

Json differences_to_json(const MeshDifferences& difference, const TriangleMesh& source,
                         const TriangleMesh& target) {
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
            {"largest_matched_region_triangles", difference.largest_region},
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
        write_vertex_map(maps[i], platform::path_of(fmt::format("{}{}.txt", prefix, i + 1)));
    outcome.summary.push_back(
        fmt::format("wrote {} symmetric alternatives to {}1.txt ...", maps.size(), prefix));
    if (maps.empty()) outcome.summary.back() = "there is no symmetric alternative";
}

// Where the connectivity differs: what the meshes share, as a map if it was asked for.
MatchOutcome shared_outcome(const MatchInput& input, const ExactArguments& arguments,
                            const MatchResult& result) {
    MatchOutcome outcome = differences_outcome(input, *result.differences);
    const std::string& first = result.exact->difference;
    outcome.summary.insert(outcome.summary.begin(), "the connectivity differs: " + first);
    outcome.details["identical"] = false;
    outcome.details["first_difference"] = first;
    if (arguments.allow_differences) return outcome;
    const std::string advice = arguments.options.weld_distance < 0
                                   ? welding_advice(input.source, input.target, "the source", "the target")
                                   : std::string();
    outcome.failure = fmt::format(
        "the meshes have different connectivity; {}{}--allow-differences writes a map of the part they share",
        advice, advice.empty() ? "" : "; ");
    return outcome;
}

}  // namespace

std::string welding_advice(const TriangleMesh& source, const TriangleMesh& target,
                           const std::string& source_name, const std::string& target_name) {
    for (const Message& message : compare(source, target).messages)
        if (message.code == MessageCode::weldable)
            return fmt::format("{}: {}; try --weld",
                               message.where.subject == Subject::source ? source_name : target_name,
                               message.sentence);
    return "";
}

MatchOutcome differences_outcome(const MatchInput& input, const MeshDifferences& differences) {
    MatchOutcome outcome;
    outcome.summary.push_back(differences.summary);
    for (std::size_t i = 0; i < std::min(max_listed, differences.edits.size()); ++i)
        outcome.summary.push_back("  " + differences.edits[i].sentence);
    if (differences.edits.size() > max_listed)
        outcome.summary.push_back(
            fmt::format("  and {} more; --report lists all", differences.edits.size() - max_listed));
    outcome.details["difference"] = differences_to_json(differences, input.source, input.target);
    return outcome;
}

MatchOutcome exact_outcome(const MatchInput& input, const ExactArguments& arguments,
                           const MatchResult& found) {
    if (!found.exact || !found.exact->identical) return shared_outcome(input, arguments, found);
    const ExactResult& result = *found.exact;
    MatchOutcome outcome;
    outcome.details = {{"identical", true}};
    Json equal = Json::array();
    for (const EqualComponents& components : result.interchangeable) {
        equal.push_back({{"triangles", components.n_triangles},
                         {"source_vertices", components.source},
                         {"target_vertices", components.target}});
    }
    outcome.details.update(Json{{"path", result.path == ExactPath::surface ? "surface" : "patches"},
                                {"components", result.n_components},
                                {"automorphisms", count_to_json(result.automorphisms)},
                                {"mirror_automorphisms", count_to_json(result.mirror_automorphisms)},
                                {"interchangeable_components", equal},
                                {"reversed_triangles", result.reversed_triangles},
                                {"winding_reversed", result.winding_reversed},
                                {"mirrored", result.mirrored}});
    if (!arguments.alternatives.empty())
        write_alternatives(result.alternatives, utf8_name(arguments.alternatives), outcome);
    return outcome;
}

ExactOptions ExactArguments::options_for_match() const {
    ExactOptions result = options;
    result.max_alternatives = alternatives.empty() ? 0 : max_alternatives;
    return result;
}

MatchOutcome ExactArguments::run(const MatchInput& input) const {
    MatchOptions how{.method = MatchMethod::exact, .exact = options_for_match()};
    how.n_threads = input.common.threads;
    how.progress = input.progress;
    const MatchResult result = match(input.source, input.target, how);
    return with_result(exact_outcome(input, *this, result), result);
}

MethodCommand add_exact_method(CLI::App& match, const std::shared_ptr<ExactArguments>& arguments) {
    match.add_flag("--allow-differences", arguments->allow_differences,
                   "exact: if the connectivity differs, write a map of the shared part, with -1 elsewhere");
    match.add_flag("--allow-mirror", arguments->options.allow_mirror,
                   "exact: also consider orientation-reversing matches");
    match
        .add_option("--weld", arguments->options.weld_distance,
                    "exact: first merge vertices up to this far apart, in mesh units; alone: 0 (spectral and "
                    "partial always merge those). Default: off")
        ->type_name("[LENGTH]")
        ->check(non_negative());
    add_path(match, "--symmetric-alternatives", arguments->alternatives,
             "exact: write the other matches of a symmetric mesh to PREFIX1.txt, PREFIX2.txt, ...")
        ->type_name("PREFIX");
    match
        .add_option("--max-alternatives", arguments->max_alternatives,
                    "exact: maximum number of symmetric alternatives, 1 to 10000")
        ->check(whole_number(1, 10'000))
        ->capture_default_str();
    return {"exact", "same connectivity: determined by connectivity alone, in any vertex order and pose",
            [arguments](const MatchInput& input) { return arguments->run(input); }};
}

}  // namespace counterpart::cli
