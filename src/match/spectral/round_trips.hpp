// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

namespace counterpart::spectral_match {

/// Per vertex of A: how far from it the map there and back ends, and by how much an edge grows beyond twice
/// its length.
Vector round_trips_and_tears(const PreparedShape& a, const PreparedShape& b, const PairedMaps& maps);

}  // namespace counterpart::spectral_match
