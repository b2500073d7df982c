// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

namespace counterpart::spectral_match {

using namespace numerics;
using namespace spectral;  // this matcher is written in its terms

/// Maps of all vertices from maps of the samples: each vertex follows its nearest sample.
PairedMaps spread(const PreparedShape& a, const PreparedShape& b, const PairedMaps& sample_maps);

/// As match_points between all vertices, but each vertex looks only near the images that it and the vertices
/// around it have in `guess`: among the vertices of the samples' cells there, and of `rings` rings of cells
/// around them. Linear in the number of vertices.
PairedMaps match_points_nearby(const PreparedShape& a, const PreparedShape& b,
                               const PairedFunctionalMaps& functional, const PairedMaps& guess, int rings,
                               const ExtraCoordinates& extra = {}, const ProgressRange& progress = {});

}  // namespace counterpart::spectral_match
