// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress_range.hpp"
#include "match/partial/tuning.hpp"

#include <counterpart/match/partial.hpp>

#include <optional>

namespace counterpart::partial_match {

/// Two whole surfaces, of which either may be fused with itself: matched as whole surfaces are (see
/// match/spectral/pipeline.hpp), whose refinement follows positions more than distances. Where the map tears
/// a mesh, that is suspected to touch itself. A map may be given to be refined instead of a search.
/// `options` are valid; their threads and progress are not looked at.
PartialResult match_fused(MeshView source, MeshView target, const PartialOptions& options,
                          std::optional<VertexMap> initial, const PartialTuning& tuning, Stopwatch watch,
                          const ProgressRange& progress);

}  // namespace counterpart::partial_match
