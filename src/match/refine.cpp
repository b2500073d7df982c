// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/map/complete.hpp>
#include <counterpart/match/refine.hpp>
#include <counterpart/mesh/measure.hpp>
#include <counterpart/spectral/zoom_out.hpp>

#include <algorithm>

namespace counterpart {
namespace {

// Shares of the progress: the two bases, then the refinement.
constexpr double source_ends = 0.2, target_ends = 0.4;

// Per source vertex, how close the way back leads to where it started.
Vector round_trip_confidence(const RefineResult& maps, MeshView source) {
    const double reach = 3 * mean_edge_length(source);
    Vector confidence(source.n_vertices());
    for (Index v = 0; v < source.n_vertices(); ++v) {
        const Index back = maps.source_from_target[maps.target_from_source[v]];
        const double off = (source.vertices.row(back) - source.vertices.row(v)).norm();
        confidence[v] = std::max(0.0, 1 - off / reach);
    }
    return confidence;
}

RefineResult refine_completed(const VertexMap& start, MeshView source, MeshView target,
                              const RefineOptions& options) {
    Stopwatch watch;
    const EigenBasis source_basis =
        eigen_basis(source, options.basis_size, part_of(options.progress, 0, source_ends));
    const EigenBasis target_basis =
        eigen_basis(target, options.basis_size, part_of(options.progress, source_ends, target_ends));
    watch.lap("eigenfunctions");
    ZoomOutResult refined = zoom_out(start, source_basis, target_basis,
                                     {.last = options.basis_size,
                                      .n_threads = options.n_threads,
                                      .progress = part_of(options.progress, target_ends, 1)});
    watch.lap("refinement");
    RefineResult result;
    result.target_from_source = std::move(refined.target_from_source);
    result.source_from_target = std::move(refined.source_from_target);
    result.confidence = round_trip_confidence(result, source);
    for (Index v = 0; v < source.n_vertices(); ++v)
        result.n_kept += result.target_from_source[v] == start[v] ? 1 : 0;
    result.stages = watch.stages();
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
