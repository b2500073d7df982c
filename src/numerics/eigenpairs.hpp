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
/// positive semi-definite, mass positive definite, by Lanczos iteration on the inverse shifted by `shift` <
/// 0. Vectors are mass-orthonormal, each with its entry of largest modulus positive; the start is fixed, so
/// the result is reproducible. 1 <= count <= size. Throws NumericalError where the factorization or the
/// iteration breaks down. `progress` is called at each step of the iteration.
Eigenpairs smallest_eigenpairs(const SparseMatrix& stiffness, const SparseMatrix& mass, int count,
                               double shift, const Progress& progress = {});

}  // namespace counterpart::numerics
