// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/product_search.hpp"

#include <counterpart/spectral/eigen_basis.hpp>

namespace counterpart::spectral_match {

/// Coefficients of omega(phi_a, phi_b) = n . (grad phi_a x grad phi_b) in the basis, for all a, b < size.
/// Changes sign when the surface is reflected.
struct OrientationTensor {
    int size = 0;  // a, b below this
    int n_coefficients = 0;
    MatrixF values;  // (size * size) x n_coefficients
};

OrientationTensor orientation_tensor(const TriangleMesh& mesh, const EigenBasis& basis, int size,
                                     int n_coefficients);

/// Agreement in [-1, 1] of the orientations under the functional map `a_from_b`: near 1 if it preserves, near
/// -1 if it reverses orientation (Ren et al. 2018).
double orientation_score(const OrientationTensor& a, const OrientationTensor& b, const MatrixF& a_from_b);

}  // namespace counterpart::spectral_match
