// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include <counterpart/base/progress.hpp>
#include <counterpart/base/types.hpp>

namespace counterpart::numerics {

/// Eigenvalues in increasing order and, in the columns, their vectors.
struct Eigenpairs {
    Vector values;
    Eigen::MatrixXd vectors;
};

/// The `count` smallest solutions of stiffness * x = lambda * mass * x, both symmetric sparse, stiffness
/// positive semi-definite, mass positive definite. Vectors are mass-orthonormal, each with its entry of
/// largest modulus positive; the start is fixed, so the result is reproducible. 1 <= count <= size.
///
/// By block_lanczos; where that fails, by Spectra's restarted Lanczos iteration; dense where `count` is
/// at least a third of the size, or that at most 200. `tolerance` bounds the residuals, relative to the
/// shifted and inverted values: eigenvalues are right to about its square. O(size * count^2). Throws
/// NumericalError where it breaks down. `progress` is called several times for each block.
Eigenpairs smallest_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                               double tolerance, const Progress& progress = {});

/// The same by Eigen's dense solver, exact to rounding: O(size^3).
Eigenpairs dense_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count);

/// The same by Spectra, for what repeats too often and as the oracle of tests. Signs as they come.
Eigenpairs spectra_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                              double tolerance, const Progress& progress = {});

}  // namespace counterpart::numerics
