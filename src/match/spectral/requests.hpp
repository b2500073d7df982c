// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/match/spectral.hpp>

namespace counterpart::spectral_match {

/// Throws InvalidInput for options that are out of range or contradict each other; the meshes have so many
/// vertices.
void require_valid(const SpectralOptions& options, Index n_source, Index n_target);

}  // namespace counterpart::spectral_match
