// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/promise.hpp"

#include "numerics/symmetric_eigen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

namespace counterpart::spectral_match {
namespace {

double curvature_correlation(const PreparedShape& from, const PreparedShape& to,
                             const std::vector<Index>& map, int scale) {
    const auto n = static_cast<Eigen::Index>(map.size());
    Vector x(n), y(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        x[i] = from.curvature(from.samples[at(i)], scale);
        y[i] = to.curvature(to.samples[at(map[at(i)])], scale);
    }
    x.array() -= x.mean();
    y.array() -= y.mean();
    const double norm = x.norm() * y.norm();
    return norm > 0 ? x.dot(y) / norm : 0;
}

// |C^T C - I|^2 / k: 0 for an isometry; beyond 1 it tells no more.
double excess(const Eigen::MatrixXf& map) {
    Eigen::MatrixXf square = map.transpose() * map;
    square.diagonal().array() -= 1;
    return square.squaredNorm() / static_cast<double>(map.cols());
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
                      const std::vector<std::vector<Index>>& neighborhoods) {
    constexpr int min_points = 5;
    double sum = 0;
    int count = 0;
    for (const std::vector<Index>& near : neighborhoods) {
        const auto n = static_cast<int>(near.size());
        if (n < min_points) continue;
        // About one of the points, so that single precision is enough.
        const Index center = near.front();
        const float* const origin_x = from.row(center).data();
        const float* const origin_y = to.row(map[at(center)]).data();
        float sums[3][3] = {}, sum_x[3] = {}, sum_y[3] = {}, squares = 0;
        for (const Index s : near) {
            const float* const at_x = from.data() + 3 * s;
            const float* const at_y = to.data() + 3 * map[at(s)];
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

}  // namespace

Promise::Promise(const SampledPair& pair, const PromiseTuning& tuning)
    : pair_(pair),
      tuning_(tuning),
      positions_a_(sample_positions(pair.a, pair.points_a.size())),
      positions_b_(sample_positions(pair.b, pair.points_b.size())),
      near_a_(neighborhoods(pair.a, at(pair.points_a.size()), tuning.radius)),
      near_b_(neighborhoods(pair.b, at(pair.points_b.size()), tuning.radius)) {}

double Promise::operator()(const PairedMaps& maps, const PairedFunctionalMaps& functional) const {
    const PreparedShape &a = pair_.a, &b = pair_.b;
    const double curvature = (curvature_correlation(a, b, maps.b_from_a, tuning_.curvature_scale) +
                              curvature_correlation(b, a, maps.a_from_b, tuning_.curvature_scale)) /
                             2;
    const double orientation = (orientation_score(a.orientation, b.orientation, functional.a_from_b) +
                                orientation_score(b.orientation, a.orientation, functional.b_from_a)) /
                               2;
    const double orthogonality = (excess(functional.a_from_b) + excess(functional.b_from_a)) / 2;
    const double rigidity = (rigid_residual(positions_a_, positions_b_, maps.b_from_a, near_a_) +
                             rigid_residual(positions_b_, positions_a_, maps.a_from_b, near_b_)) /
                            2;
    double total = curvature + tuning_.orientation * orientation -
                   tuning_.orthogonality * std::min(orthogonality, 1.0) - tuning_.rigidity * rigidity;
    if (!pair_.priors.empty()) total -= disagreement(a, b, pair_.priors, maps);
    return std::isnan(total) ? -std::numeric_limits<double>::infinity() : total;
}

}  // namespace counterpart::spectral_match
