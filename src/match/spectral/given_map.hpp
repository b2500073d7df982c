// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/polish.hpp"

#include <counterpart/map/vertex_map.hpp>

namespace counterpart::spectral_match {

/// A map of input vertices as one of the level, with its score. A vertex without an image follows the nearest
/// one that has one; a vertex of B goes back to the vertex of A whose image is nearest. Of a large mesh the
/// vertices of its proxy count. Throws InvalidInput if nothing is matched. O(V log V).
Map given_map(const Level& whole, const VertexMap& target_from_source);

/// Stage 5 from a map instead of a race. Where it is nearly an isometry it is grown by ZoomOut; in any case
/// its last rounds of refinement run on all vertices, with both maps pulling. What equation 4 likes best is
/// taken, and that may be the map as it was given: it never gets worse.
Polished polish_given(const Map& given, const Level& whole, const ProgressRange& progress);

}  // namespace counterpart::spectral_match
