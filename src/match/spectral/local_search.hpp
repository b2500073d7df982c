// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/shape.hpp"

namespace counterpart::spectral_match {

/// As match_points between all vertices, but each vertex looks only near the image of its sample: for meshes
/// where all against all is too much. `sample_maps` are between the samples.
PairedMaps match_points_nearby(const Shape& a, const Shape& b, const PairedFunctionalMaps& functional,
                               const PairedMaps& sample_maps);

}  // namespace counterpart::spectral_match
