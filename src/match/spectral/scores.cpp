// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/scores.hpp"

#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace counterpart::spectral_match {
namespace {

double curvature_correlation(const PreparedShape& from, const PreparedShape& to,
                             const std::vector<Index>& map, int scale) {
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
    const Eigen::Vector3d s = numerics::symmetric_eigenvalues(square).cwiseMax(0.0).cwiseSqrt();
    return s[2] + s[1] + (covariance.determinant() < 0 ? -s[0] : s[0]);
}

// Over all neighborhoods: what is left of the images after the best rotation.
double rigid_residual(const MatrixF& from, const MatrixF& to, const std::vector<Index>& map,
                      const Neighborhoods& near) {
    constexpr int min_points = 5;
    double sum = 0;
    int count = 0;
    for (std::size_t s = 0; s + 1 < near.first.size(); ++s) {
        const auto n = static_cast<int>(near.first[s + 1] - near.first[s]);
        if (n < min_points) continue;
        // About one of the points, so that single precision is enough.
        const Index center = near.samples[near.first[s]];
        const float* const origin_x = from.row(center).data();
        const float* const origin_y = to.row(map[static_cast<std::size_t>(center)]).data();
        float sums[3][3] = {}, sum_x[3] = {}, sum_y[3] = {}, squares = 0;
        for (std::size_t i = near.first[s]; i < near.first[s + 1]; ++i) {
            const float* const at_x = from.data() + 3 * near.samples[i];
            const float* const at_y = to.data() + 3 * map[static_cast<std::size_t>(near.samples[i])];
            for (int r = 0; r < 3; ++r) {
                const float x = at_x[r] - origin_x[r], y = at_y[r] - origin_y[r];
                sum_x[r] += x;
                sum_y[r] += y;
                squares += x * x + y * y;
                for (int c = 0; c < 3; ++c) sums[r][c] += x * (at_y[c] - origin_y[c]);
            }
        }
        Eigen::Matrix3f moments;
        for (int r = 0; r < 3; ++r) {
            squares -= (sum_x[r] * sum_x[r] + sum_y[r] * sum_y[r]) / static_cast<float>(n);
            for (int c = 0; c < 3; ++c)
                moments(r, c) = sums[r][c] - sum_x[r] * sum_y[c] / static_cast<float>(n);
        }
        if (squares <= 0) continue;
        sum += 1 - 2 * attained(moments.cast<double>()) / squares;
        ++count;
    }
    return count > 0 ? sum / count : 0;
}

MatrixF sample_positions(const PreparedShape& shape, Index n) {
    MatrixF positions(n, 3);
    for (Index i = 0; i < n; ++i)
        positions.row(i) = shape.mesh.vertices.row(shape.samples[static_cast<std::size_t>(i)]).cast<float>();
    return positions;
}

// |C^T C - I|^2 / k.
double excess(const Eigen::MatrixXf& map) {
    Eigen::MatrixXf square = map.transpose() * map;
    square.diagonal().array() -= 1;
    return square.squaredNorm() / static_cast<double>(map.cols());
}

double drift(const MatrixF& map, const VectorF& row_frequencies, const VectorF& column_frequencies) {
    double sum = 0;
    for (Eigen::Index i = 0; i < map.rows(); ++i) {
        for (Eigen::Index j = 0; j < map.cols(); ++j) {
            const double x = row_frequencies[i] * row_frequencies[i];
            const double y = column_frequencies[j] * column_frequencies[j];
            const double gap = (x - y) / (x + y + 1e-9), entry = map(i, j);
            sum += entry * entry * gap * gap;
        }
    }
    return sum / static_cast<double>(map.cols());
}

}  // namespace

SampledPair::SampledPair(const PreparedShape& shape_a, const PreparedShape& shape_b, std::size_t n,
                         double radius, const Priors& known)
    : a(shape_a),
      b(shape_b),
      points_a(sampled(shape_a, n)),
      points_b(sampled(shape_b, n)),
      positions_a(sample_positions(shape_a, points_a.size())),
      positions_b(sample_positions(shape_b, points_b.size())),
      near_a(shape_a, n, radius),
      near_b(shape_b, n, radius),
      priors(known) {}

Neighborhoods::Neighborhoods(const PreparedShape& shape, std::size_t n, double radius) : first{0} {
    n = std::min(n, shape.samples.size());
    const auto n_centers =
        std::min<Eigen::Index>(shape.sample_distances.rows(), static_cast<Eigen::Index>(n));
    for (Eigen::Index s = 0; s < n_centers; ++s) {
        for (std::size_t t = 0; t < n; ++t)
            if (shape.sample_distances(s, shape.samples[t]) < radius)
                samples.push_back(static_cast<Index>(t));
        first.push_back(samples.size());
    }
}

double frequency_drift(const SampledPair& pair, const PairedFunctionalMaps& functional) {
    const VectorF &on_a = pair.points_a.frequencies, &on_b = pair.points_b.frequencies;
    return (drift(functional.a_from_b, on_a, on_b) + drift(functional.b_from_a, on_b, on_a)) / 2;
}

Scores score_maps(const SampledPair& pair, const PairedMaps& maps, const PairedFunctionalMaps& functional,
                  const ScoreWeights& weights) {
    Scores scores;
    scores.curvature = (curvature_correlation(pair.a, pair.b, maps.b_from_a, weights.curvature_scale) +
                        curvature_correlation(pair.b, pair.a, maps.a_from_b, weights.curvature_scale)) /
                       2;
    scores.orientation = (orientation_score(pair.a.orientation, pair.b.orientation, functional.a_from_b) +
                          orientation_score(pair.b.orientation, pair.a.orientation, functional.b_from_a)) /
                         2;
    scores.orthogonality = (excess(functional.a_from_b) + excess(functional.b_from_a)) / 2;
    scores.rigidity = (rigid_residual(pair.positions_a, pair.positions_b, maps.b_from_a, pair.near_a) +
                       rigid_residual(pair.positions_b, pair.positions_a, maps.a_from_b, pair.near_b)) /
                      2;
    scores.drift = frequency_drift(pair, functional);
    scores.total = weights.curvature * scores.curvature + weights.orientation * scores.orientation -
                   weights.orthogonality * std::min(scores.orthogonality, 1.0) -
                   weights.drift * scores.drift - weights.rigidity * scores.rigidity;
    if (!pair.priors.empty()) scores.total -= disagreement(pair.a, pair.b, pair.priors, maps);
    return scores;
}

}  // namespace counterpart::spectral_match
