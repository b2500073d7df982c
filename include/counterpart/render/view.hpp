// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>

namespace counterpart {

/// From where a mesh is looked at: the rows are the directions, in the mesh's coordinates, that point right,
/// up and towards the viewer in the picture. A rotation.
using View = Eigen::Matrix3d;

struct ViewOptions {
    /// "auto": the widest side of the mesh, a little from the left and from above; "front", "back", "left",
    /// "right", "top", "bottom"; or "AZIMUTH,ELEVATION" in degrees, seen from the front turned to the right
    /// and raised.
    std::string direction = "auto";
    /// "x", "y", "z", "-x", "-y", "-z": what is up in the mesh's coordinates; "auto": y, or z where the mesh
    /// is much flatter along y than along z.
    std::string up = "auto";
};

/// With y up the front is +z, with z up it is -y, as mesh formats have it. An automatic view looks along the
/// horizontal principal axis of the surface in which it is thinnest, from its front. Throws InvalidInput for
/// options it does not know. O(V).
View find_view(const TriangleMesh& mesh, const ViewOptions& options = {});

/// The view of the target in which it looks as the source does in `source_view`: turned by the rotation that
/// takes matched vertices closest to each other (Procrustes). Where that is less than 40 degrees the two are
/// in different poses rather than in different places, and the target keeps the source's view. Also where
/// fewer than three vertices are matched.
View carry_view(const View& source_view, const TriangleMesh& source, const TriangleMesh& target,
                const VertexMap& target_from_source);

/// The mesh in picture space: as seen in `view`, scaled to unit area, the middle of its box at 0. Everything
/// else that is drawn with the mesh goes the same way.
class Placement {
  public:
    Placement(const TriangleMesh& mesh, const View& view);
    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const {
        return scale_ * (point * view_.transpose()) + offset_;
    }
    TriangleMesh operator()(const TriangleMesh& mesh) const;
    void shift(const Eigen::RowVector3d& by) { offset_ += by; }
    double scale() const { return scale_; }
    /// Half the sides of the mesh's box in the picture.
    const Eigen::RowVector3d& half_size() const { return half_size_; }

  private:
    View view_;
    double scale_ = 1;
    Eigen::RowVector3d offset_ = Eigen::RowVector3d::Zero(), half_size_ = Eigen::RowVector3d::Zero();
};

}  // namespace counterpart
