// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/transfer/corner_attribute.hpp>

namespace counterpart {

/// Normals for the target's corners (n x 3 unit vectors): hard edges are where the source's are, and each
/// normal stands to the target's surface as the source's does to the source's. It turns as the edges around
/// it do, and then by what takes the source's geometric normal there to the target's. Geometric normals are
/// area-weighted means over the triangles that share the normal. Edited normals thus are kept, and come back
/// to rounding on a copy. Throws as carry_corners does.
CarriedCorners carry_normals(const SurfaceMap& source_from_target, const TriangleMesh& source,
                             const TriangleMesh& target, const CornerAttribute& normals,
                             const CarryCornersOptions& options = {});

}  // namespace counterpart
