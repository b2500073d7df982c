// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "load_map.hpp"

#include "judgment.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/io/map_file.hpp>
#include <counterpart/map/project.hpp>
#include <counterpart/match/compare.hpp>

#include <utility>
#include <variant>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

void require_size(Index size, const MeshPair& pair) {
    if (size == pair.source.n_vertices()) return;
    throw InvalidInput(fmt::format(
        "the map has {} entries, but its source mesh has {} vertices{}", size, pair.source.n_vertices(),
        size == pair.target.n_vertices()
            ? "; its target mesh has as many as the map: it seems to be the inverse map"
            : ""));
}

std::vector<std::pair<std::string, VertexMap>> runner_ups(const MatchResult& result) {
    std::vector<std::pair<std::string, VertexMap>> found;
    if (result.spectral)
        for (const SpectralAlternative& other : result.spectral->alternatives)
            found.emplace_back(other.description, other.target_from_source);
    if (result.partial)
        for (const PartialAlternative& other : result.partial->alternatives)
            found.emplace_back(
                fmt::format("runner-up: {:.0f} % of the vertices go elsewhere", 100 * other.moved),
                other.target_from_source);
    return found;
}

}  // namespace

SurfaceMap between_vertices(const VertexMap& map, const MeshPair& pair, const CommonOptions& options,
                            int extend) {
    return project_map(pair.source, pair.target, map,
                       {.extend = extend,
                        .n_threads = options.threads,
                        .progress = progress_bar("placing images", options)});
}

LoadedMap load_map(const std::filesystem::path& file, const MeshPair& pair) {
    try {
        std::variant<VertexMap, SurfaceMap> map = read_map(file);
        require_size(std::visit([](const auto& kind) { return kind.source_size(); }, map), pair);
        if (auto* points = std::get_if<SurfaceMap>(&map)) {
            points->target_triangles = pair.target.n_triangles();
            require_valid(*points, pair.source.n_vertices(), pair.target.n_triangles());
            return {nearest_corners(*points, pair.target), std::move(*points)};
        }
        return {{std::get<VertexMap>(map).image(), pair.target.n_vertices()}, std::nullopt};
    } catch (const InvalidInput& error) {
        throw IoError(fmt::format("{}: {}", utf8_name(file), error.what()));
    }
}

SurfaceMap load_surface_map(const std::filesystem::path& file, const MeshPair& pair,
                            const CommonOptions& options, int extend) {
    LoadedMap map = load_map(file, pair);
    return map.points ? std::move(*map.points) : between_vertices(map.vertices, pair, options, extend);
}

std::string caution(const Json& report) {
    return report.value("verdict", "") == to_string(Advice::do_not_use)
               ? " (by a map that is not to be used: see above)"
               : "";
}

FoundMap<VertexMap> matched(const MeshPair& pair, const CommonOptions& options, const Landmarks& landmarks) {
    const std::optional<Message> order =
        landmarks.empty() ? same_order(pair.source, pair.target) : std::nullopt;
    if (order) {
        say(options, "no map is given: the meshes have the same triangles, so vertex i goes to vertex i");
        if (order->severity != Severity::notice) say_messages(options, {*order}, pair);
        return {identity_map(pair.source.n_vertices())};
    }
    MatchOptions how{.n_threads = options.threads, .progress = progress_bar("matching", options)};
    how.spectral.landmarks = landmarks;
    const MatchResult result = match(pair.source, pair.target, how);
    how.progress = {};
    say(options,
        fmt::format("no map is given: matched by '{}', because {}", to_string(result.method), result.reason));
    const Judgment judgment{result.messages, result.causes};
    say_verdict(options, judgment, pair);
    say_messages(options, result.messages, pair);
    Json report = judgment.report();
    report["matched_by"] = to_string(result.method);
    report["match_messages"] = to_json(result.messages);
    std::vector<std::string> warnings;
    for (const Message& message : result.messages)
        if (message.severity != Severity::notice) warnings.push_back(named(message, pair));
    return {result.target_from_source, report, result.confidence, warnings, runner_ups(result)};
}

FoundMap<SurfaceMap> surface_map_or_match(const std::filesystem::path& file, const MeshPair& pair,
                                          const CommonOptions& options, const Landmarks& landmarks) {
    if (!file.empty()) return {load_surface_map(file, pair, options)};
    const FoundMap<VertexMap> found = matched(pair, options, landmarks);
    return {between_vertices(found.map, pair, options, 0), found.report};
}

}  // namespace counterpart::cli
