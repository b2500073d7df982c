// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/symmetry/alignment.hpp"

namespace counterpart::symmetry {

/// Place, size and direction of a set of points: one row of 9 numbers, the center and the square root of the
/// covariance (off the diagonal times sqrt 2). The squared distance of two rows is, after Gelbrich 1990,
/// about the least mean squared distance of the two sets under any pairing of their points.
using Moments = Eigen::Matrix<double, 1, 9>;
Moments moments_of(const Eigen::RowVector3d& center, const Eigen::Matrix3d& covariance);

/// Center and covariance of one side of the pairs.
struct Spread {
    Eigen::RowVector3d center = Eigen::RowVector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};
Spread spread_of(const std::vector<PointPair>& pairs, Eigen::RowVector3d PointPair::*side);

/// The target of each source, -1 for those left over; the smaller side is wholly assigned. Of least sum up to
/// ExactTuning::max_optimal on the larger side; beyond, the closest pairs first.
std::vector<Index> assign_components(const std::vector<Moments>& sources,
                                     const std::vector<Moments>& targets);

}  // namespace counterpart::symmetry
