// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart::differences {

/// Whether a map keeps the lengths of edges, but for a common factor, clearly better than the source laid on
/// itself by chance does (see chance_among). True of meshes that are not like themselves anywhere. O(F log
/// F).
bool lengths_fit(const VertexMap& target_from_source, MeshView source, MeshView target);

}  // namespace counterpart::differences
