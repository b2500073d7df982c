// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
//
// The linear algebra of the thin-plate spline; what depends only on the control points is computed once.
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart::align {

/// phi(|a_i - b_j|): r^2 log r in 2D, -r in 3D.
Matrix spline_kernel(const Matrix& a, const Matrix& b);

/// With P = [1 c] = [Q1 Q2] [R; 0] and Q2' Phi Q2 = U S U', the weights of the spline to images Y are
/// w = Q2 U (S + lambda I)^-1 (Q2 U)' Y: after one O(K^3) decomposition each fit costs O(K^2).
class SplineSystem {
  public:
    explicit SplineSystem(const Matrix& controls);

    struct Fit {
        Matrix affine;        // (D + 1) x D
        Matrix coefficients;  // of the weights in the basis Q2 U
        Matrix fitted;        // K x D: the spline at the controls
    };
    /// Least |Y - P A - Phi w|^2 + bending_weight trace(w' Phi w) + affine_weight |A - identity|^2.
    Fit fit(const Matrix& images, double bending_weight, double affine_weight) const;
    /// K x D
    Matrix weights(const Fit& fit) const { return basis_.transpose() * fit.coefficients; }

  private:
    Eigen::RowVectorXd center_;   // of the controls; the affine part is fitted about it
    Matrix polynomial_;           // P = [1 controls - center], K x (D + 1)
    Matrix basis_;                // (Q2 U)', (K - rank P) x K
    Matrix kernel_basis_;         // Phi Q2 U, K x (K - rank P)
    Vector bending_;              // S
    Matrix normal_;               // P' P
    Matrix polynomial_solution_;  // pseudo-inverse of P, for affine_weight = 0
};

}  // namespace counterpart::align
