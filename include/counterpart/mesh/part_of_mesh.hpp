// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Meshes as scanners deliver them, made of whole ones, so that the true map is known.
#pragma once

#include <counterpart/mesh/triangle_mesh.hpp>

#include <cstdint>
#include <vector>

namespace counterpart {

struct PartOfMesh {
    TriangleMesh mesh;
    std::vector<Index> whole_from_part;  ///< the true map
};

/// The triangles that are marked, one mark each, and the vertices that they use, in order. Polygons are not
/// kept. O(V + F). Throws InvalidInput for an invalid mesh or another number of marks.
PartOfMesh part_of(MeshView mesh, const std::vector<char>& is_kept);

/// The triangles whose three corners lie on the side of a plane that its normal points to: normal . x >
/// offset. O(V + F). Throws InvalidInput for an invalid mesh, or a normal or offset that is not finite.
PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset);

/// Without the triangles that come within `radius`, in a straight line, of `count` vertices drawn at random.
/// O(count * V). Throws InvalidInput for an invalid mesh, a negative count or radius.
PartOfMesh cut_holes(MeshView mesh, int count, double radius, std::uint64_t seed);

}  // namespace counterpart
