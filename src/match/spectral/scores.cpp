// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/scores.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace counterpart::spectral_match {
namespace {

double curvature_correlation(const Shape& from, const Shape& to, const std::vector<Index>& map, int scale) {
    const auto n = static_cast<Eigen::Index>(map.size());
    Vector x(n), y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x[i] = from.curvature(from.samples[static_cast<std::size_t>(i)], scale);
        y[i] = to.curvature(to.samples[static_cast<std::size_t>(map[static_cast<std::size_t>(i)])], scale);
    }
    x.array() -= x.mean();
    y.array() -= y.mean();
    const double norm = x.norm() * y.norm();
    return norm > 0 ? x.dot(y) / norm : 0;
}

// Sum of the singular values of a 3 x 3 covariance, the smallest with the sign of the determinant: what the
// best proper rotation attains (Kabsch).
double attained(const Eigen::Matrix3d& covariance) {
    const Eigen::Matrix3d square = covariance.transpose() * covariance;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(square, Eigen::EigenvaluesOnly);
    const Eigen::Vector3d s = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
    return s[2] + s[1] + (covariance.determinant() < 0 ? -s[0] : s[0]);
}

// Over all distance samples: the samples within the radius, their images, and what is left of the images
// after the best rotation.
double rigid_residual(const Shape& from, const Shape& to, const std::vector<Index>& map, double radius) {
    constexpr int least = 5;
    const Eigen::Index n_centers =
        std::min<Eigen::Index>(from.sample_distances.rows(), static_cast<Eigen::Index>(map.size()));
    double sum = 0;
    int count = 0;
    for (Eigen::Index s = 0; s < n_centers; ++s) {
        Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
        Eigen::RowVector3d sum_x = Eigen::RowVector3d::Zero(), sum_y = sum_x;
        double squares = 0;
        int n = 0;
        for (std::size_t t = 0; t < map.size(); ++t) {
            if (from.sample_distances(s, from.samples[t]) >= radius) continue;
            const Eigen::RowVector3d x = from.mesh.vertices.row(from.samples[t]);
            const Eigen::RowVector3d y = to.mesh.vertices.row(to.samples[static_cast<std::size_t>(map[t])]);
            product += x.transpose() * y;
            squares += x.squaredNorm() + y.squaredNorm();
            sum_x += x;
            sum_y += y;
            ++n;
        }
        if (n < least) continue;
        product -= sum_x.transpose() * sum_y / n;
        squares -= (sum_x.squaredNorm() + sum_y.squaredNorm()) / n;
        if (squares <= 0) continue;
        sum += 1 - 2 * attained(product) / squares;
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

}  // namespace

Scores score_maps(const SampledPair& pair, const PairedMaps& maps, const PairedFunctionalMaps& functional,
                  int curvature_scale, double radius) {
    Scores scores;
    scores.curvature = (curvature_correlation(pair.a, pair.b, maps.b_from_a, curvature_scale) +
                        curvature_correlation(pair.b, pair.a, maps.a_from_b, curvature_scale)) /
                       2;
    scores.orientation = orientation_score(pair.a.orientation, pair.b.orientation, functional.a_from_b);
    const Eigen::MatrixXf c = functional.a_from_b;
    Eigen::MatrixXf excess = c.transpose() * c;
    excess.diagonal().array() -= 1;
    scores.orthogonality = excess.squaredNorm() / static_cast<double>(c.cols());
    scores.rigidity = (rigid_residual(pair.a, pair.b, maps.b_from_a, radius) +
                       rigid_residual(pair.b, pair.a, maps.a_from_b, radius)) /
                      2;
    // Weights fitted by pairwise ranking of right against wrong maps.
    scores.total = scores.curvature + 0.15 * scores.orientation - 2.5 * std::min(scores.orthogonality, 1.0) -
                   0.7 * scores.rigidity;
    return scores;
}

}  // namespace counterpart::spectral_match
