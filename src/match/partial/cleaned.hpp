// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/surface/preprocess.hpp"

#include <string>

namespace counterpart::partial_match {

/// What is matched of a mesh. Throws UnsuitableMesh, which calls it by `name`, without area or for fewer than
/// 50 distinct vertices.
surface_match::Preprocessed cleaned(MeshView mesh, const std::string& name);

/// Throws UnsuitableMesh for more vertices than distances to them from so many samples fit into memory.
void require_room_for_distances(const surface_match::Preprocessed& source,
                                const surface_match::Preprocessed& target, int n_samples);

}  // namespace counterpart::partial_match
