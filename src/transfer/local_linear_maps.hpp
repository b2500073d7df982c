// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/surface_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::morphing {

struct LocalLinearMapsOptions {
    /// Weight of the similarity of neighboring maps relative to how well each explains the edges around it,
    /// above 0.
    double smoothness = 1;
};

/// For each target vertex the linear map from directions at its image on the source to directions on the
/// target: the smoothest field of 3 x 3 matrices A_v that take the source's edges, as the map lays them out,
/// to the target's. If the target is an affine image of the source, all are its linear part. What the edges
/// do not determine, such as the normal direction of a flat mesh, follows the surroundings and ultimately the
/// best global similarity. Minimizes
///
///     sum over edges vw of (|A_v e - e'|^2 + |A_w e - e'|^2) / h^2 + smoothness |A_v - A_w|^2
///
/// with e = x_w - x_v on the source, e' on the target, h^2 the mean of |e|^2; one sparse system of 3
/// n_vertices unknowns, factorized once. Unmatched vertices follow their surroundings. Throws
/// InvalidInput if the map does not fit or fewer than three vertices not on one line are matched.
std::vector<Eigen::Matrix3d> local_linear_maps(const SurfaceMap& source_from_target, MeshView source,
                                               MeshView target, const LocalLinearMapsOptions& options = {});

}  // namespace counterpart::morphing
