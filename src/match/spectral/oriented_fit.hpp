// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "match/spectral/prepared_shape.hpp"

namespace counterpart::spectral_match {

/// Coefficients of curvature and heat kernels on either shape, k x d, in corresponding columns, and
/// corresponding vertices.
struct KnownFunctions {
    Eigen::MatrixXd on_a, on_b;
    std::vector<std::pair<Index, Index>> vertices;
};

/// The same with A and B exchanged.
KnownFunctions reversed(KnownFunctions known);

/// The functional map C (coefficients on A from those on B, k x k) that minimizes
///
///     |C F_B - F_A|^2 + 3 sum_ij C_ij^2 ((lambda_i - lambda_j) / lambda_max)^2
///         + weight sum_p |C G_B(p) - G_A(p) C|^2
///
/// over corresponding columns of F and vertices p. G(p) takes a function h to n . (grad f x grad h), f the
/// heat kernel at p: it commutes with maps that preserve orientation and anticommutes with those that reverse
/// it (Ren, Poulenard, Wonka, Ovsjanikov 2018, section 4), so that the map cannot be mirrored in one half of
/// the body alone. One factorization of a k^2 x k^2 system.
Eigen::MatrixXd fit_oriented(const PreparedShape& a, const PreparedShape& b, const KnownFunctions& known,
                             double weight, double heat_time);

}  // namespace counterpart::spectral_match
