// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/exact.hpp>

namespace counterpart::exact {

/// The match of two meshes that have polygons, wherever these begin and however they were cut.
ExactResult match_polygons(MeshView source, MeshView target, const ExactOptions& options);

}  // namespace counterpart::exact
