// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include <counterpart/align/transform.hpp>

namespace counterpart {

Eigen::RowVector3d Similarity::operator()(const Eigen::RowVector3d& point) const {
    return (scale * (rotation * point.transpose()) + translation).transpose();
}

Points Similarity::operator()(PointsView points) const {
    return (scale * (points * rotation.transpose())).rowwise() + translation.transpose();
}

Points Affine::operator()(PointsView points) const {
    return (points * linear.transpose()).rowwise() + translation.transpose();
}

}  // namespace counterpart
