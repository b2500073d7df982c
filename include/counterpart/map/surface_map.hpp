// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <vector>

namespace counterpart {

/// A point on a surface: a triangle and barycentric weights.
struct SurfacePoint {
    static constexpr Index unmatched = -1;

    Index triangle = unmatched;  ///< counted from 0
    /// In the triangle's corner order; each at least 0, sum 1.
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();

    bool matched() const { return triangle != unmatched; }
    bool operator==(const SurfacePoint&) const = default;
};

/// A sub-vertex correspondence: every source vertex maps to a point anywhere on the target's surface. Name
/// instances by direction: `target_from_source`.
struct SurfaceMap {
    std::vector<SurfacePoint> image;  ///< one per source vertex
    Index target_triangles = 0;       ///< number of target triangles

    Index source_size() const { return static_cast<Index>(image.size()); }
    const SurfacePoint& operator[](Index source_vertex) const {
        return image[static_cast<std::size_t>(source_vertex)];
    }
    bool operator==(const SurfaceMap&) const = default;
};

/// Throws InvalidInput naming the first bad entry: the map must have `source_size` entries, each unmatched or
/// on a triangle in 0 .. target_triangles - 1 with weights that are at least 0 and sum to 1 (within 1e-6).
void require_valid(const SurfaceMap& map, Index source_size, Index target_triangles);

/// The same correspondence: each image becomes a corner, with weight 1, of its first triangle. Images that
/// are in no triangle of the target become unmatched. O(V + F).
SurfaceMap surface_map_of(const VertexMap& target_from_source, MeshView target);

/// The corner with the largest weight (the first of equals). O(V).
VertexMap nearest_corners(const SurfaceMap& target_from_source, MeshView target);

/// Transfers per-vertex values of the target (n_target_vertices x K) to the source vertices: K weighted means
/// each. Rows of unmatched vertices are NaN. O(V K).
Matrix transfer_values(const SurfaceMap& target_from_source, MeshView target, const Matrix& values);

/// Positions of the images: transfer_values of the target's vertices.
Points image_positions(const SurfaceMap& target_from_source, MeshView target);

Index count_matched(const SurfaceMap& map);

}  // namespace counterpart
