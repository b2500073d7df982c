// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/spectral/laplacian.hpp>

namespace counterpart {

/// The lowest eigenfunctions of the Laplace-Beltrami operator: the Fourier basis of a surface.
struct EigenBasis {
    Vector eigenvalues;              ///< k, increasing, in 1 / squared mesh units; the first is 0
    Eigen::MatrixXd eigenfunctions;  ///< V x k, orthonormal under `mass`; largest entry of each positive
    Vector mass;                     ///< V, area of each vertex

    int size() const { return static_cast<int>(eigenvalues.size()); }
};

/// The `n_functions` lowest eigenfunctions (fewer if the mesh has fewer vertices), by block Lanczos
/// iteration. The first `n_functions` do not depend on how the vertices are numbered, up to the sign rule's
/// ties and the choice within repeated eigenvalues. About O(V * n_functions^2). `progress` is called at every
/// step of the iteration. Throws InvalidInput if n_functions < 1, NumericalError if the iteration fails,
/// Canceled.
EigenBasis eigen_basis(const LaplaceBeltrami& laplacian, int n_functions, const Progress& progress = {});
EigenBasis eigen_basis(MeshView mesh, int n_functions, const Progress& progress = {});

}  // namespace counterpart
