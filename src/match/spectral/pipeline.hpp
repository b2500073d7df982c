// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The stages in their order: prepare -> proposals -> race -> moves -> polish -> confidence.
#pragma once

#include "match/spectral/prepared_shape.hpp"

#include <counterpart/base/progress.hpp>
#include <counterpart/match/spectral.hpp>

namespace counterpart::spectral_match {

/// Stages 2 to 6 between the input meshes of two prepared shapes. `options` are valid and name vertices of
/// the inputs; their threads and progress are not looked at.
SpectralResult match(const PreparedShape& source, const PreparedShape& target, const SpectralOptions& options,
                     const SpectralTuning& tuning = {}, const ProgressRange& progress = {},
                     Stopwatch watch = {});

/// All stages between two meshes, which are prepared at the same time.
SpectralResult match(MeshView source, MeshView target, const SpectralOptions& options,
                     const PreparationOptions& preparation, const ProgressRange& progress = {},
                     Stopwatch watch = {});

}  // namespace counterpart::spectral_match
