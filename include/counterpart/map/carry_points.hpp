// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

namespace counterpart {

/// Carries points that lie on the source or near it, such as landmarks, to the target's surface (n x 3, in
/// the target's frame): a point goes where the map takes the closest point of the source, which is between
/// the images of its triangle's corners and from there the closest point of the target. Corners without an
/// image do not count; a point of which no corner has one gets NaN. Throws InvalidInput for a map that does
/// not fit the meshes or a point that is not finite. O((n + F) log F).
Points carry_points(PointsView points, MeshView source, MeshView target,
                    const SurfaceMap& target_from_source);

}  // namespace counterpart
