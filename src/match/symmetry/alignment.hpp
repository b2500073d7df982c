// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/align/transform.hpp>

#include <vector>

namespace counterpart::symmetry {

/// A point of the source and its partner.
struct PointPair {
    Eigen::RowVector3d source, target;
    double weight = 1;
};

/// A similarity, after a point reflection where `reflects`.
struct Alignment {
    Similarity similarity;
    bool reflects = false;

    Eigen::RowVector3d operator()(const Eigen::RowVector3d& point) const {
        return similarity(reflects ? Eigen::RowVector3d(-point) : point);
    }
    Eigen::Matrix3d linear() const { return (reflects ? -1 : 1) * similarity.scale * similarity.rotation; }
};

/// Least squares over the pairs; with `may_reflect` the better one of rotation and reflection. The identity
/// for no pairs.
Alignment fit_alignment(const std::vector<PointPair>& pairs, bool may_reflect);

/// The motion near `point`: least squares with weights that fall with the fourth power of the distance to it.
Alignment fit_alignment_near(const Eigen::RowVector3d& point, std::vector<PointPair> pairs, bool may_reflect);

/// Weighted mean of the squared distances that are left.
double squared_error(const Alignment& alignment, const std::vector<PointPair>& pairs);

}  // namespace counterpart::symmetry
