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

    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const;
    Points operator()(PointsView points) const;
    Points operator()(const Points& points) const { return (*this)(PointsView(points)); }
};

/// The translation that moves the mean of `source` onto the mean of `target`; their numbers of points may
/// differ. Throws InvalidInput if either is empty. O(N).
Similarity align_centroids(PointsView source, PointsView target);

struct KabschOptions {
    bool with_scale = false;  ///< also find the best uniform scale (Procrustes); else 1
    /// A prior on the rotation. Its weight counts like points whose weights times squared radii sum to
    /// `prior_weight` (squared mesh units, at least 0). Where the points do not determine the rotation (fewer
    /// than three, or on a line), the prior does.
    Eigen::Matrix3d prior_rotation = Eigen::Matrix3d::Identity();
    double prior_weight = 0;
};

/// The similarity T of least sum of weights[i] |T(source_i) - target_i|^2, after Kabsch 1976 and Umeyama
/// 1991; reflections are excluded. `weights`: empty (all 1) or one per point, at least 0 and not all 0.
/// Throws InvalidInput if the sizes differ, there is no point, or a weight is negative. O(N).
Similarity kabsch(PointsView source, PointsView target, const Vector& weights = {},
                  const KabschOptions& options = {});

/// The transforms to choose from.
enum class TransformModel {
    rigid,       ///< rotation and translation
    similarity,  ///< rigid and uniform scale
    affine       ///< any orientation-preserving linear map, and translation
};

/// x -> linear * x + translation.
struct Affine {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();

    Points operator()(PointsView points) const;
};

/// The transform of the given model with the least sum of weights times squared distances between transformed
/// `source` points and `target` points (row by row; at least 3, affine 4). Closed form. Reflections are
/// excluded: where the least-squares solution reflects, the best proper rotation is taken (rigid, similarity)
/// or InvalidInput is thrown (affine). `weights` empty = all 1. Throws InvalidInput for too few or degenerate
/// points (on one line; affine: in one plane). Rotation: Kabsch 1976; scale: Umeyama 1991. O(N).
Affine fit_transform(PointsView source, PointsView target, TransformModel model = TransformModel::rigid,
                     const Vector& weights = {});

}  // namespace counterpart
