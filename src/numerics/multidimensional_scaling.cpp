// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "numerics/multidimensional_scaling.hpp"

#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>

namespace counterpart::numerics {
namespace {

// The three leading principal coordinates of the doubly centered squared distances.
Points classical_solution(const Matrix& distances) {
    const Eigen::Index n = distances.rows();
    Eigen::MatrixXd gram = -0.5 * distances.array().square();
    const Eigen::RowVectorXd mean = gram.colwise().mean();
    gram.rowwise() -= mean;
    gram.colwise() -= mean.transpose();
    gram.array() += mean.mean();
    const auto eigen = symmetric_eigen(gram);
    Points points = Points::Zero(n, 3);
    for (Eigen::Index k = 0; k < std::min<Eigen::Index>(3, n); ++k) {
        const double variance = std::max(eigen.values[n - 1 - k], 0.0);
        points.col(k) = std::sqrt(variance) * eigen.vectors.col(n - 1 - k);
    }
    return points;
}

// The Guttman transform: every point to the mean of where the others would have it.
Points majorized(PointsView points, const Matrix& distances) {
    const Eigen::Index n = points.rows();
    Points next = Points::Zero(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j) {
            const Eigen::RowVector3d offset = points.row(i) - points.row(j);
            const double length = offset.norm();
            if (length > 0) next.row(i) += distances(i, j) / length * offset;
        }
    }
    return next / static_cast<double>(n);
}

}  // namespace

Points multidimensional_scaling(const Matrix& distances, int iterations) {
    if (distances.rows() == 0) return Points(0, 3);
    const Matrix symmetric = 0.5 * (distances + distances.transpose());
    Points points = classical_solution(symmetric);
    for (int i = 0; i < iterations; ++i) points = majorized(points, symmetric);
    return points;
}

}  // namespace counterpart::numerics
