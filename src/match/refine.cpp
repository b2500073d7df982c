// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/verdict/doubts.hpp"

#include <counterpart/map/complete.hpp>
#include <counterpart/match/refine.hpp>
#include <counterpart/match/spectral.hpp>

#include <utility>

#include <fmt/format.h>

namespace counterpart {
namespace {

RefineResult refine_completed(const VertexMap& start, MeshView source, MeshView target,
                              const RefineOptions& options) {
    SpectralOptions refining{
        .n_alternatives = 0, .n_threads = options.n_threads, .progress = options.progress};
    refining.initial = start;
    SpectralResult refined = match_spectral(source, target, refining, {.basis_size = options.basis_size});
    RefineResult result;
    result.target_from_source = std::move(refined.target_from_source);
    result.source_from_target = std::move(refined.source_from_target);
    result.confidence = std::move(refined.confidence);
    result.score = refined.score;
    for (Index v = 0; v < source.n_vertices(); ++v)
        result.n_kept += result.target_from_source[v] == start[v] ? 1 : 0;
    result.messages = std::move(refined.messages);
    result.messages.push_back(
        {MessageCode::refined, Severity::notice,
         fmt::format("refined the given map: {} of {} images stayed", result.n_kept, source.n_vertices())});
    for (Message& doubt : judgment::doubts(result.target_from_source, result.confidence, source, 1))
        result.messages.push_back(std::move(doubt));
    result.stages = std::move(refined.stages);
    return result;
}

}  // namespace

RefineResult refine_map(const SurfaceMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options) {
    const CompletedMap completed = complete_map(target_from_source, source, target);
    return refine_completed(nearest_corners(completed.target_from_source, target), source, target, options);
}

RefineResult refine_map(const VertexMap& target_from_source, MeshView source, MeshView target,
                        const RefineOptions& options) {
    require_valid(target_from_source, source.n_vertices(), target.n_vertices());
    if (count_matched(target_from_source) == source.n_vertices())
        return refine_completed(target_from_source, source, target, options);
    return refine_completed(complete_map(target_from_source, source, target), source, target, options);
}

}  // namespace counterpart
