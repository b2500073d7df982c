// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/match/spectral.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>

namespace counterpart::choice {

/// Where a map goes against what is said of it besides landmarks (excluded, aligned, up, facing): how, as a
/// sentence; else empty. O(V log V) for each excluded pair.
std::string contradiction(const VertexMap& target_from_source, MeshView source, MeshView target,
                          const SpectralOptions& said);

}  // namespace counterpart::choice
