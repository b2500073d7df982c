// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/spectral/eigen_basis.hpp>

#include <vector>

namespace counterpart::spectral {

/// Approximate lowest eigenfunctions of a large mesh, sought among combinations of local functions: column p
/// of `partition` (V x P, sparse, entries at least 0, rows sum to 1) is the one around sample p. The reduced
/// problem has P unknowns: Magnet and Ovsjanikov, "Scalable and Efficient Functional Map Computations on
/// Dense Meshes", 2023. Throws InvalidInput if sizes differ or n_functions is not in 1 .. P.
EigenBasis subspace_eigen_basis(const LaplaceBeltrami& laplacian, const SparseMatrix& partition,
                                int n_functions, const Progress& progress = {});

}  // namespace counterpart::spectral
