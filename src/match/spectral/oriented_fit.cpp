// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#include "match/spectral/oriented_fit.hpp"

#include "numerics/dense_systems.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace counterpart::spectral_match {
namespace {

// G(v) among the first k functions.
Eigen::MatrixXd rotated_gradient(const PreparedShape& shape, Index v, Eigen::Index k, double heat_time) {
    const Eigen::VectorXd heat = shape.basis.eigenfunctions.row(v).head(k).transpose().array() *
                                 (-heat_time * shape.basis.eigenvalues.head(k).array()).exp();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(k, k);
    const OrientationTensor& tensor = shape.orientation;
    for (Eigen::Index i = 0; i < k; ++i)
        for (Eigen::Index j = 0; j < k; ++j)
            result.col(j) +=
                heat[i] * tensor.values.row(i * tensor.size + j).head(k).transpose().cast<double>();
    return result;
}

}  // namespace

KnownFunctions reversed(KnownFunctions known) {
    known.on_a.swap(known.on_b);
    for (auto& [va, vb] : known.vertices) std::swap(va, vb);
    return known;
}

Eigen::MatrixXd fit_oriented(const PreparedShape& a, const PreparedShape& b, const KnownFunctions& known,
                             double weight, double heat_time) {
    const Eigen::Index k = known.on_a.rows();
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const Eigen::MatrixXd gram = known.on_b * known.on_b.transpose();
    const RowMajor cross = known.on_a * known.on_b.transpose();
    const Vector &on_a = a.basis.eigenvalues, &on_b = b.basis.eigenvalues;
    const double largest = std::max(on_a[k - 1], on_b[k - 1]);
    // Unknowns are the rows of C one after another.
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(k * k, k * k);
    for (Eigen::Index r = 0; r < k; ++r) {
        system.block(r * k, r * k, k, k) = gram;
        for (Eigen::Index c = 0; c < k; ++c) {
            const double gap = (on_a[r] - on_b[c]) / largest;
            system(r * k + c, r * k + c) += 3 * gap * gap + 1e-6;
        }
    }
    for (const auto& [va, vb] : known.vertices) {
        Eigen::MatrixXd g_a = rotated_gradient(a, va, k, heat_time),
                        g_b = rotated_gradient(b, vb, k, heat_time);
        const double size = std::max(g_a.norm() * g_b.norm(), 1e-12);
        const Eigen::MatrixXd aa = g_a.transpose() * g_a, bb = g_b * g_b.transpose();
        for (Eigen::Index r = 0; r < k; ++r) {
            // The lower half only.
            for (Eigen::Index q = 0; q <= r; ++q) {
                auto block = system.block(r * k, q * k, k, k);
                block -= weight / size * (g_a(r, q) * g_b + g_a(q, r) * g_b.transpose());
                block.diagonal().array() += weight / size * aa(r, q);
                if (r == q) block += weight / size * bb;
            }
        }
    }
    const Eigen::VectorXd rows =
        numerics::solve_positive_definite(system, Eigen::Map<const Eigen::VectorXd>(cross.data(), k * k));
    return Eigen::Map<const RowMajor>(rows.data(), k, k);
}

}  // namespace counterpart::spectral_match
