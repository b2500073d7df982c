// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The local step of as-rigid-as-possible deformation (Sorkine and Alexa 2007, section 2), with a scale for
// each neighborhood: limbs of two individuals are not equally thick. In single precision, on plain arrays:
// matching spends a fifth of its time here.
#pragma once

#include <counterpart/base/types.hpp>

#include <array>
#include <vector>

#include <Eigen/Geometry>

namespace counterpart::align {

/// The weighted edges of a surface at rest, those around vertex i from `first[i]` on.
struct Springs {
    std::vector<Index> first, neighbor;
    std::vector<float> weight;               // w_ij
    std::vector<std::array<float, 3>> edge;  // rest_i - rest_j
    std::vector<float> square;               // of each vertex: sum w_ij |rest_i - rest_j|^2

    /// `stiffness` has minus the weight of each edge off its diagonal.
    Springs(const SparseMatrix& stiffness, PointsView rest);

    std::size_t n_vertices() const { return square.size(); }
};

/// What best takes the rest neighborhood of a vertex into the present one.
struct LocalSimilarity {
    Eigen::Quaternionf rotation = Eigen::Quaternionf::Identity();
    float scale = 1;

    Eigen::Matrix3f linear() const { return scale * rotation.toRotationMatrix(); }
};
using LocalSimilarities = std::vector<LocalSimilarity>;

/// Of the scale of a neighborhood, so that none vanishes.
struct ScaleBounds {
    double least = 0.5, largest = 2;
};

/// Rotations are followed from the ones before, if there are any, by at most four Newton steps.
LocalSimilarities local_similarities(const Springs& springs, PointsView now, const ScaleBounds& bounds,
                                     LocalSimilarities before = {});

/// Vertices marked in `spoiled` take the mean of what is around them, from the rim of their patch inward:
/// what fits a crumpled neighborhood best would keep it crumpled. Without such a rim they stay as they are.
LocalSimilarities continued_inward(const Springs& springs, const std::vector<char>& spoiled,
                                   LocalSimilarities similarities);

/// sum_j w_ij (s_i R_i + s_j R_j) / 2 (rest_i - rest_j) for every i (equation 8, with scales).
Points moved_differences(const Springs& springs, const LocalSimilarities& similarities);

/// What the similarities leave of `now`, relative to its size: 0 = nothing, at most 1.
double strain(const Springs& springs, PointsView now, const LocalSimilarities& similarities);

}  // namespace counterpart::align
