// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/partial/surface.hpp"

#include <vector>

namespace counterpart::partial_match {

/// Where a map tears a surface: edges whose ends go to places far apart. A surface that is fused with itself,
/// as where a hand touches a hip, must be torn there.
struct Tears {
    std::vector<Index> vertices;  // of torn edges, increasing
    TriangleMesh mesh;            // the surface without the torn triangles; the same vertices
};

Tears find_tears(const Surface& part, const Surface& whole, const std::vector<Index>& image,
                 const TearTuning& tuning);

/// Vertices minus edges plus triangles: each handle takes 2 off.
Index euler_characteristic(MeshView mesh);

}  // namespace counterpart::partial_match
