// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// Parts of a mesh, with their true maps.
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/variants.hpp>

#include <functional>

namespace counterpart::test {

struct PartOfMesh {
    TriangleMesh mesh;
    VertexMap whole_from_part;  ///< the true map
};

/// The triangles whose three corners are kept.
PartOfMesh part_of(MeshView mesh, const std::function<bool(const Eigen::RowVector3d&)>& is_kept);

/// The side of the plane that normal points to: normal . x > offset.
PartOfMesh cut_by_plane(MeshView mesh, const Eigen::RowVector3d& normal, double offset);

/// Without what lies within `radius` of `count` of its vertices, drawn at random.
PartOfMesh with_holes(MeshView mesh, int count, double radius, std::uint64_t seed);

}  // namespace counterpart::test
