// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/map/vertex_map.hpp>
#include <counterpart/mesh/triangle_mesh.hpp>

#include <string>

namespace counterpart::render {

/// A viewing rotation: its rows are the directions, in the mesh's coordinates, that point right, up and
/// toward the viewer in the image.
using Camera = Eigen::Matrix3d;

struct CameraOptions {
    /// "auto": the widest side of the mesh, a little from the left and from above; "front", "back", "left",
    /// "right", "top", "bottom"; or "AZIMUTH,ELEVATION" in degrees, to the right of and above the front.
    std::string direction = "auto";
    /// The up axis in the mesh's coordinates: "x", "y", "z", "-x", "-y", "-z"; "auto":
    /// find_up_axis.
    std::string up = "auto";
};

/// The axis along which the mesh is most likely upright, "y", "z" or "-y": y, or z where the mesh is
/// much flatter along y than along z, unless it stands at least twice as well along another. It stands on
/// what is in its lowest tenth, better the larger the area between and the higher the center of its surface;
/// above the area, or it falls over. A guess from the shape: of 115 people and animals 99 are upright. Throws
/// InvalidInput for an invalid mesh. O(V log V).
std::string find_up_axis(MeshView mesh);

/// With y up the front is +z, with z up it is -y, as is usual in mesh formats. An automatic view looks along
/// the horizontal principal axis of least extent, from the front. Throws InvalidInput for options it does not
/// know and for an invalid mesh. O(V), and what find_up_axis takes.
Camera find_camera(MeshView mesh, const CameraOptions& options = {});

/// The view in which the target looks as the source does in `source_view`: rotated by the best rotation
/// between matched vertices (Procrustes). If that is less than 40 degrees, the meshes differ in pose rather
/// than in orientation, and the target gets the source's view; also if fewer than three vertices are matched.
Camera matching_camera(const Camera& source_view, MeshView source, MeshView target,
                       const VertexMap& target_from_source);

/// Transforms a mesh, and what is drawn with it, to image space: rotated into `view`, scaled to unit area,
/// with the center of its box at 0.
class Placement {
  public:
    Placement(MeshView mesh, const Camera& view);
    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const {
        return scale_ * (point * view_.transpose()) + offset_;
    }
    TriangleMesh operator()(MeshView mesh) const;
    void shift(const Eigen::RowVector3d& by) { offset_ += by; }
    double scale() const { return scale_; }
    /// Half the size of the mesh's box in image space.
    const Eigen::RowVector3d& half_size() const { return half_size_; }

  private:
    Camera view_;
    double scale_ = 1;
    Eigen::RowVector3d offset_ = Eigen::RowVector3d::Zero(), half_size_ = Eigen::RowVector3d::Zero();
};

}  // namespace counterpart::render
