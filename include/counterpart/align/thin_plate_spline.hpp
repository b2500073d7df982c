// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/types.hpp>

namespace counterpart {

/// The thin-plate spline in 2 or 3 dimensions:
///     f(x) = [1 x] A + sum over a of phi(|x - c_a|) w_a,   sum over a of [1 c_a]^T w_a = 0
/// with phi(r) = r^2 log r in 2D and -r in 3D (Bookstein 1989; Wahba 1990).
class ThinPlateSpline {
  public:
    /// The spline of least sum of |f(controls_a) - images_a|^2 + regularization * bending energy. `controls`
    /// and `images`: K x D, D = 2 or 3, K >= 1; `regularization` >= 0, 0 interpolates. Controls may lie on a
    /// line or in a plane: directions that they do not determine stay as close to the identity as possible.
    /// Throws InvalidInput for other sizes, values that are not finite, or coincident controls with different
    /// images and no regularization. O(K^3).
    ThinPlateSpline(const Matrix& controls, const Matrix& images, double regularization = 0);

    /// From its parts: controls K x D, affine (D + 1) x D with the translation in row 0, weights K x D.
    ThinPlateSpline(Matrix controls, Matrix affine, Matrix weights);

    /// f of N x D points. O(N K).
    Matrix operator()(const Matrix& points) const;

    const Matrix& controls() const { return controls_; }
    const Matrix& affine() const { return affine_; }
    const Matrix& weights() const { return weights_; }

  private:
    Matrix controls_, affine_, weights_;
};

}  // namespace counterpart
