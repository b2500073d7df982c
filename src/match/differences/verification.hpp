// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/differences/prediction.hpp"
#include "match/isomorphism/dart_map.hpp"

namespace counterpart::differences {

/// The map without what chance explains and without what lies in the wrong place.
///
/// Matched triangles fall into regions that hang together over edges. The largest first, a region is kept if
/// it lies where the regions kept before, near it, expect it; where there are none, if its irregular vertices
/// tell where it belongs: the information in them, -log2 of the frequency of each valence but the commonest,
/// exceeds by DifferenceTuning::significance bits what it takes to choose one of all placements, or if it is
/// half of a mesh. Then single vertices at differences go whose neighbors expect them elsewhere.
///
/// `partner`: the target triangle of each source triangle or -1; triangles in `known` are kept without
/// question. O(F).
std::vector<Index> without_misplaced(const isomorphism::DartMap& source, MeshView source_mesh,
                                     MeshView target_mesh, const std::vector<Index>& map,
                                     const std::vector<Index>& partner, const std::vector<bool>& known,
                                     Prediction& prediction);

}  // namespace counterpart::differences
