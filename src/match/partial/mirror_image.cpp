// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/partial/mirror_image.hpp"

#include <Eigen/Geometry>

namespace counterpart::partial_match {
namespace {

Eigen::Vector3d across(const Eigen::Vector3d& up, const Eigen::Vector3d& facing) {
    if (up.isZero(0)) return Eigen::Vector3d::UnitX();
    return facing.isZero(0) ? up.unitOrthogonal() : up.normalized().cross(facing.normalized()).normalized();
}

}  // namespace

TriangleMesh mirror_image(MeshView mesh, const Eigen::Vector3d& up, const Eigen::Vector3d& facing) {
    const Eigen::Vector3d normal = across(up, facing);
    TriangleMesh image = mesh.copy();
    image.vertices -= 2 * (image.vertices * normal).eval() * normal.transpose();
    image.triangles.col(1).swap(image.triangles.col(2));
    return image;
}

}  // namespace counterpart::partial_match
