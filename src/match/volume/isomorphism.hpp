// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/match/volume.hpp>

namespace counterpart::volume {

/// match_volume with method exact: fills in what it says of exact.
VolumeResult match_connectivity(const TetrahedralMesh& source, const TetrahedralMesh& target,
                                bool allow_mirror, const Progress& progress);

}  // namespace counterpart::volume
