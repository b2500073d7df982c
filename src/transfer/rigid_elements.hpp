// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// A mesh for as-rigid-as-possible energies: elements that should keep their shape, and the rotation of each
// between two poses.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart::morphing {

/// The triangles of a mesh, followed by single edges that join nearby components (so that eyes stay in their
/// head), written as triangles (a, b, b). Side c of an element goes from its corner c to corner c + 1.
struct RigidElements {
    Triangles corners;
    Points side_weights;  ///< not negative; mean about 1
    Triangles across;     ///< the element on the other side of each side, -1 where there is none

    Index count() const { return static_cast<Index>(corners.rows()); }
    Eigen::RowVector3d side(PointsView vertices, Index element, int c) const {
        return vertices.row(corners(element, (c + 1) % 3)) - vertices.row(corners(element, c));
    }
};
/// Weights are the cotangent weights of the two poses' mean, kept within positive bounds.
RigidElements make_rigid_elements(MeshView first, PointsView last);

/// One rotation vector per element (axis times angle, perhaps beyond pi) that best rotates its sides and its
/// normal from the first pose onto the last. Of the vectors for the same rotation the one nearest to a
/// neighbor's is taken, so that the field is as smooth as possible; elements without a normal take a
/// neighbor's.
Points rotation_field(const RigidElements& elements, PointsView first, PointsView last);

struct RotationField {
    Points vectors;           ///< one per element
    std::vector<char> folds;  ///< 1 where the element has its surroundings' rotation, not its own
};
/// Where the surface folds over between the poses, no choice of full turns makes the rotations around the
/// fold consistent. The regions of `rings` rings around such jumps of the field, and around the `seeds`, get
/// the rotation of what surrounds them instead.
RotationField soften_folds(const RigidElements& elements, Points vectors, const std::vector<Index>& seeds,
                           int rings);

}  // namespace counterpart::morphing
