// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart {

/// x -> scale * rotation * x + translation. The rotation is proper: never a reflection.
struct Similarity {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
    double scale = 1;

    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const {
        return (scale * (rotation * point.transpose()) + translation).transpose();
    }
    Points operator()(const Points& points) const {
        return (scale * (points * rotation.transpose())).rowwise() + translation.transpose();
    }
};

/// Moves the mean of `source` onto the mean of `target`, which may have another number of points. Throws
/// InvalidInput if either is empty. O(N).
Similarity align_centroids(const Points& source, const Points& target);

struct KabschOptions {
    bool with_scale = false;  ///< also find the best uniform scale (Procrustes); else 1
    /// A rotation believed beforehand, and how much: it counts like points with a summed weight times squared
    /// radius of `prior_weight` (squared units, 0 or more). Where the points leave the rotation open (fewer
    /// than three, or on a line) the prior decides.
    Eigen::Matrix3d prior_rotation = Eigen::Matrix3d::Identity();
    double prior_weight = 0;
};

/// The similarity T of least sum of weights[i] |T(source_i) - target_i|^2, after Kabsch 1976 and Umeyama
/// 1991; reflections are excluded. `weights`: empty (all 1) or one per point, 0 or more, not all 0. Throws
/// InvalidInput if the sizes differ, there is no point, or a weight is negative. O(N).
Similarity kabsch(const Points& source, const Points& target, const Vector& weights = {},
                  const KabschOptions& options = {});

}  // namespace counterpart
