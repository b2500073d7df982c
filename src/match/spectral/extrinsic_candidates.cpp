// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/extrinsic_candidates.hpp"

#include "base/parallel.hpp"
#include "numerics/rotation.hpp"
#include "numerics/symmetric_eigen.hpp"

#include <array>

#include <Eigen/LU>

namespace counterpart::spectral_match {
namespace {

// Turned into the principal axes, the longest first, and of unit variance along that.
numerics::MatrixF in_principal_axes(const numerics::MatrixF& positions) {
    const Eigen::MatrixXd centered =
        positions.cast<double>().rowwise() - positions.cast<double>().colwise().mean();
    const auto spread = numerics::symmetric_eigen(Eigen::Matrix3d(centered.transpose() * centered));
    Eigen::Matrix3d axes = spread.vectors.rowwise().reverse();
    if (axes.determinant() < 0) axes.col(2) *= -1;
    const double largest = std::max(spread.values[2], 1e-20) / static_cast<double>(positions.rows());
    return (centered * axes / std::sqrt(largest)).cast<float>();
}

// The 24 rotations of a cube.
std::vector<Eigen::Matrix3f> cube_rotations() {
    std::vector<Eigen::Matrix3f> result;
    const std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (const auto& order : orders) {
        for (int signs = 0; signs < 8; ++signs) {
            Eigen::Matrix3f turn = Eigen::Matrix3f::Zero();
            for (int i = 0; i < 3; ++i)
                turn(i, order[static_cast<std::size_t>(i)]) = (signs >> i & 1) != 0 ? -1 : 1;
            if (turn.determinant() > 0) result.push_back(turn);
        }
    }
    return result;
}

PairedMaps nearest(const numerics::MatrixF& x, const numerics::MatrixF& y) {
    numerics::BestPartners found =
        numerics::best_partners(x, y, x.rowwise().squaredNorm() / 2, y.rowwise().squaredNorm() / 2);
    return {std::move(found.of_row), std::move(found.of_column)};
}

}  // namespace

std::vector<PairedMaps> extrinsic_candidates(const SampledPair& pair, int n_iterations) {
    const numerics::MatrixF a = in_principal_axes(sample_positions(pair.a, pair.points_a.size())),
                            b = in_principal_axes(sample_positions(pair.b, pair.points_b.size()));
    const std::vector<Eigen::Matrix3f> turns = cube_rotations();
    std::vector<PairedMaps> results(turns.size());
    parallel_for(turns.size(), 1, [&](std::size_t i) {
        numerics::MatrixF moved = a * turns[i];
        for (int iteration = 0; iteration < n_iterations; ++iteration) {
            results[i] = nearest(moved, b);
            // Of rows: moved * R^T against their partners on B, both ways.
            Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
            for (Eigen::Index s = 0; s < moved.rows(); ++s)
                covariance +=
                    (b.row(results[i].b_from_a[static_cast<std::size_t>(s)]).transpose() * moved.row(s))
                        .cast<double>();
            for (Eigen::Index t = 0; t < b.rows(); ++t)
                covariance +=
                    (b.row(t).transpose() * moved.row(results[i].a_from_b[static_cast<std::size_t>(t)]))
                        .cast<double>();
            moved = moved * numerics::fit_rotation(covariance).rotation.transpose().cast<float>();
        }
        results[i] = nearest(moved, b);
    });
    return results;
}

}  // namespace counterpart::spectral_match
