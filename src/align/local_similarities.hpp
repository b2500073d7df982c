// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The local step of as-rigid-as-possible deformation (Sorkine and Alexa 2007, section 2), with a scale for
// each neighborhood: limbs of two individuals are not equally thick.
#pragma once

#include <counterpart/base/types.hpp>

#include <vector>

namespace counterpart::align {

/// What best takes the rest neighborhood of a vertex into the present one.
struct LocalSimilarity {
    Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
    double scale = 1;

    Eigen::Matrix3d linear() const { return scale * rotation; }
};

/// Of the scales, so that nothing vanishes.
struct ScaleBounds {
    double least = 0.5, largest = 2;
};

/// `stiffness` has minus the weight of each edge off its diagonal. Rotations are followed from the ones
/// before, if there are any.
std::vector<LocalSimilarity> local_similarities(const SparseMatrix& stiffness, PointsView rest,
                                                PointsView now, const ScaleBounds& bounds,
                                                std::vector<LocalSimilarity> before = {});

/// Vertices marked in `spoiled` take the mean of what is around them, from the rim of their patch inward:
/// what fits a crumpled neighborhood best would keep it crumpled. Without such a rim they stay as they are.
void continue_inward(const SparseMatrix& stiffness, const std::vector<char>& spoiled,
                     std::vector<LocalSimilarity>& similarities);

/// sum_j w_ij (s_i R_i + s_j R_j) / 2 (rest_i - rest_j) for every i (equation 8, with scales).
Points moved_differences(const SparseMatrix& stiffness, PointsView rest,
                         const std::vector<LocalSimilarity>& similarities);

}  // namespace counterpart::align
