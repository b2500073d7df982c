// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart {

/// x -> scale * rotation * x + offset, on rows; the rotation may be a reflection where that is asked for.
struct Motion {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();  ///< scale * rotation
    Eigen::RowVector3d offset = Eigen::RowVector3d::Zero();

    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const {
        return point * linear.transpose() + offset;
    }
};

/// A point of the source and its partner.
struct PointPair {
    Eigen::RowVector3d source, target;
    double weight = 1;
};

/// Least squares over the pairs (Umeyama 1991). With `reflection` the best of rotations and reflections. Too
/// few or degenerate pairs leave what they do not determine at a rotation of least turn; no pairs give the
/// identity.
Motion fit_similarity(const std::vector<PointPair>& pairs, bool reflection = false);

/// Mean over the weights of the squared distances after the motion.
double residual(const Motion& similarity, const std::vector<PointPair>& pairs);

}  // namespace counterpart
