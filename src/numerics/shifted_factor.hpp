// SPDX-FileCopyrightText: 2026 The counterpart authors
// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/sparse_cholesky.hpp"

#include <counterpart/base/types.hpp>

namespace counterpart::numerics {

/// stiffness - shift * mass = L D L^T, both symmetric sparse, mass positive definite; one ordering of the
/// unknowns serves all shifts. Without pivoting: where a pivot is 0, or so small that solutions are not
/// accurate, the factorization fails and another shift must be taken.
class ShiftedFactor {
  public:
    ShiftedFactor(const SparseMatrix& stiffness, const SparseMatrix& mass);

    /// False if it breaks down, or leaves more than 1e-8 of a random right-hand side.
    bool factorize(double shift);

    /// How many eigenvalues lie below the shift: the negative entries of D (Sylvester's law of inertia).
    int n_below() const;

    /// The solutions for several right-hand sides, in the columns, which share each look at L.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

  private:
    SparseMatrix stiffness_, mass_;
    SparseCholesky factor_;
};

}  // namespace counterpart::numerics
