// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/fused.hpp"

#include "match/partial/requests.hpp"
#include "match/spectral/pipeline.hpp"
#include "match/surface/tears.hpp"

#include <counterpart/mesh/measure.hpp>

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace counterpart::partial_match {
namespace {

// Where the images are, in units of the target's sqrt(area).
Points places(const VertexMap& map, MeshView target) {
    return target.vertices(map.image(), Eigen::all) / std::sqrt(surface_area(target));
}

double share_moved(const Points& best, const Points& other, double distance) {
    return ((best - other).rowwise().norm().array() >= distance).cast<double>().mean();
}

void add_touching(Subject subject, const std::vector<Index>& vertices, std::vector<Message>& messages) {
    if (!vertices.empty())
        messages.push_back(
            {MessageCode::fused,
             Severity::notice,
             fmt::format("may be fused with itself: the map tears at {} of its vertices", vertices.size()),
             {subject, vertices}});
}

}  // namespace

PartialResult match_fused(MeshView source, MeshView target, const PartialOptions& options,
                          std::optional<VertexMap> initial, const PartialTuning& tuning, Stopwatch watch,
                          const ProgressRange& progress) {
    SpectralOptions matching = as_of_spectral(options);
    matching.initial = std::move(initial);
    SpectralResult found = spectral_match::match(source, target, matching,
                                                 {.n_samples = options.n_samples, .seed = options.seed},
                                                 progress.part(0, 0.98), std::move(watch));

    PartialResult result;
    result.part = Part::neither;
    result.scale = std::sqrt(surface_area(target) / surface_area(source));
    result.source_share = result.target_share = 1;
    const Points best = places(found.target_from_source, target);
    for (SpectralAlternative& other : found.alternatives) {
        const double moved =
            share_moved(best, places(other.target_from_source, target), tuning.confidence.same_place);
        result.alternatives.push_back({std::move(other.target_from_source), other.score, moved});
    }
    result.source_touching = surface_match::torn_vertices(source, best);
    result.target_touching = surface_match::torn_vertices(target, places(found.source_from_target, source));
    result.target_from_source = std::move(found.target_from_source);
    result.source_from_target = std::move(found.source_from_target);
    result.confidence = std::move(found.confidence);
    result.score = found.score;
    result.margin = found.margin;
    result.messages = std::move(found.messages);
    add_touching(Subject::source, result.source_touching, result.messages);
    add_touching(Subject::target, result.target_touching, result.messages);
    result.stages = std::move(found.stages);
    return result;
}

}  // namespace counterpart::partial_match
