// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>

#include <utility>
#include <vector>

namespace counterpart {

/// Pairs (source vertex, target vertex) known to be the same point. A vertex may be in several pairs or in
/// none; every pair counts once.
struct GroundTruth {
    std::vector<std::pair<Index, Index>> pairs;
};

/// Source vertex i with the map's image of it; unmatched vertices have no truth.
GroundTruth truth_from_map(const VertexMap& target_from_source);

/// Entry k of both names the same point of a template; it has no truth where either is unmatched. Throws
/// InvalidInput if the two differ in length.
GroundTruth truth_from_template(const VertexMap& source_from_template, const VertexMap& target_from_template);

/// At most `count` pairs (at least 2), evenly spread over the list, the first and the last among them.
GroundTruth sampled(const GroundTruth& truth, Index count);

}  // namespace counterpart
