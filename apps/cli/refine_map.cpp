// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "refine_map.hpp"

#include <counterpart/base/errors.hpp>
#include <counterpart/map/complete.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/spectral/zoom_out.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace counterpart::cli {
namespace {

constexpr int basis_size = 150;

// Shares of the progress bar: the two bases, then the refinement.
constexpr double source_ends = 0.2, target_ends = 0.4;

// Per source vertex, how close the way back leads to where it started: 1 to itself, 0 three mean edges off.
Vector round_trip_confidence(const ZoomOutResult& maps, const TriangleMesh& source) {
    const double reach = 3 * mean_edge_length(source);
    Vector confidence(source.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index back = maps.source_from_target[maps.target_from_source[v]];
        const double off = (source.vertices.row(back) - source.vertices.row(v)).norm();
        confidence[v] = std::max(0.0, 1 - off / reach);
    }
    return confidence;
}

VertexMap completed(const LoadedMap& map, const TriangleMesh& source, const TriangleMesh& target) {
    if (count_matched(map.vertices) == source.n_vertices()) return map.vertices;
    if (!map.points) return complete_map(map.vertices, source, target);
    return nearest_corners(complete_map(*map.points, source, target).target_from_source, target);
}

}  // namespace

MatchOutcome refine_map(const MatchInput& input, const LoadedMap& initial) {
    Stopwatch watch;
    const VertexMap start = completed(initial, input.source, input.target);
    const EigenBasis source = eigen_basis(input.source, basis_size, part_of(input.progress, 0, source_ends));
    const EigenBasis target =
        eigen_basis(input.target, basis_size, part_of(input.progress, source_ends, target_ends));
    watch.lap("eigenfunctions");
    const ZoomOutResult refined = zoom_out(start, source, target,
                                           {.last = basis_size,
                                            .n_threads = input.common.threads,
                                            .progress = part_of(input.progress, target_ends, 1)});
    watch.lap("refinement");
    MatchOutcome outcome;
    outcome.method = "spectral";
    outcome.target_from_source = refined.target_from_source;
    outcome.source_from_target = refined.source_from_target;
    outcome.confidence = round_trip_confidence(refined, input.source);
    Index n_kept = 0;
    for (Index v = 0; v < input.source.n_vertices(); ++v)
        n_kept += refined.target_from_source[v] == start[v] ? 1 : 0;
    outcome.messages.push_back(
        fmt::format("refined the given map: {} of {} images stayed", n_kept, input.source.n_vertices()));
    outcome.details = {{"kept_images", n_kept}};
    outcome.stages = watch.stages();
    return outcome;
}

}  // namespace counterpart::cli
