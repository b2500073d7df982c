// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/exact/notices.hpp"
#include "match/isomorphism/dart_map.hpp"

namespace counterpart::exact {

struct Isomorphism {
    ExactResult result;  ///< without messages
    Described source;
};

/// The isomorphism of two meshes of triangles that fits their geometry best. Of coned meshes
/// (mesh/polygons.hpp) the vertices from the given ones on are the middles of polygons, which only match each
/// other.
Isomorphism match_triangles(MeshView source, MeshView target, const ExactOptions& options,
                            Index source_center = isomorphism::no_center,
                            Index target_center = isomorphism::no_center);

}  // namespace counterpart::exact
