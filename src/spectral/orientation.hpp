// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/eigen_basis.hpp>

namespace counterpart::spectral {

/// Coefficients of omega(phi_i, phi_j) = n . (grad phi_i x grad phi_j) in the basis, for all i, j < size.
/// Changes sign when the surface is reflected.
struct OrientationTensor {
    int size = 0;            ///< i, j below this
    int n_coefficients = 0;  ///< eigenfunctions that omega is expanded in
    Eigen::MatrixXf values;  ///< (size * size) x n_coefficients; row i * size + j
};

/// Sizes are limited to that of the basis; both must be at least 2, else InvalidInput, as for a basis of
/// another mesh. O(F size^2 n_coefficients).
OrientationTensor orientation_tensor(MeshView mesh, const EigenBasis& basis, int size = 20,
                                     int n_coefficients = 30);

/// Agreement in [-1, 1] of the orientations of two surfaces under a functional map, `a_from_b` (k_A x k_B,
/// the coefficients on A of each eigenfunction of B): near 1 if it preserves, near -1 if it reverses
/// orientation. Ren, Poulenard, Wonka, Ovsjanikov 2018. Throws InvalidInput for an empty map.
double orientation_score(const OrientationTensor& a, const OrientationTensor& b,
                         const Eigen::MatrixXf& a_from_b);

}  // namespace counterpart::spectral
